/** OpenEXR files: images as named channels of numbers. */
@NullMarked
package lightning.format.exr;

import org.jspecify.annotations.NullMarked;
