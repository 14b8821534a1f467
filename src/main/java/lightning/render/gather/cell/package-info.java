/** Points on surfaces as columns, and the cells of places and directions into which they are divided. */
@NullMarked
package lightning.render.gather.cell;

import org.jspecify.annotations.NullMarked;
