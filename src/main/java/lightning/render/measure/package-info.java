/**
 * Measurements of cost and exactness of pictures: verification against a full trace, guarantees, savings, and what accuracy and effects cost.
 * Runs over many scenes belong to {@code bench}.
 */
@NullMarked
package lightning.render.measure;

import org.jspecify.annotations.NullMarked;
