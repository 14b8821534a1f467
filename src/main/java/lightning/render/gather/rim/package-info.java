/** Additional rays of gather points through the rims of openings: where they are needed, and what they meet. */
@NullMarked
package lightning.render.gather.rim;

import org.jspecify.annotations.NullMarked;
