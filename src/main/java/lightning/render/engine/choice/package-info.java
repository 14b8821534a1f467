/** Which engine works when. */
package lightning.render.engine.choice;
