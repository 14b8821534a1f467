/**
 * Parts that only the paper's modes of 1998 use: updates that scale stored contributions by ratios, with an error bound, and
 * reflection hit lists for mirrors on demand. Other packages access the updates through {@link
 * lightning.render.relight.plan.UpdateMethod}.
 */
@NullMarked
package lightning.render.relight.paper;

import org.jspecify.annotations.NullMarked;
