/**
 * Columns of rows: flat arrays that share one index. The rows of each kind define a closed set of columns, which determines how
 * they are allocated, measured and shared.
 */
@NullMarked
package lightning.render.column;

import org.jspecify.annotations.NullMarked;
