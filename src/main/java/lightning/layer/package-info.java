/** Layers (AOVs) of an image that add up to it, written as one OpenEXR file. */
@NullMarked
package lightning.layer;

import org.jspecify.annotations.NullMarked;
