/** Sequences: several shots that share one light rig. */
@NullMarked
package lightning.format.sequence;

import org.jspecify.annotations.NullMarked;
