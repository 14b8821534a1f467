/**
 * Layers (AOVs) of an image that add up to it, written as one OpenEXR file.
 * Pictures without layers are written by {@code format.image}.
 */
@NullMarked
package lightning.layer;

import org.jspecify.annotations.NullMarked;
