/** Radiance HDR images, with their content validated. */
@NullMarked
package lightning.format.hdr;

import org.jspecify.annotations.NullMarked;
