/** Which engine works when. */
package lightning.engine.choice;
