/** Image files: PNG, OpenEXR, Radiance HDR, PFM, XPM, and color tables. */
@NullMarked
package lightning.format.image;

import org.jspecify.annotations.NullMarked;
