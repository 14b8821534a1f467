/** Selection of the engine of a process. */
package lightning.render.engine.choice;
