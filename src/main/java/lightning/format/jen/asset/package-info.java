/** Files that a scene names: where they are, and how they are decoded. */
@NullMarked
package lightning.format.jen.asset;

import org.jspecify.annotations.NullMarked;
