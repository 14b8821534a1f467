/** Radiance HDR images, with their content validated. */
package lightning.format.hdr;
