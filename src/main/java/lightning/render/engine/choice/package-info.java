/** Selection of the engine of a process. */
@NullMarked
package lightning.render.engine.choice;

import org.jspecify.annotations.NullMarked;
