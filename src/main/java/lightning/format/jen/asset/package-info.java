/**
 * Files that a scene names: where they are, and how they are decoded.
 * The decoded values are records of {@code scene.asset}.
 */
@NullMarked
package lightning.format.jen.asset;

import org.jspecify.annotations.NullMarked;
