/** Pictures of high dynamic range in Radiance's format, held to what they have. */
package lightning.format.hdr;
