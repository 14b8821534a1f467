/**
 * The pixel cache (paper §2.4): what the first pass learned at every pixel, as tiles of plain columns.
 *
 * <p>A picture is cut into tiles of 32×32 pixels. A tile holds one level for the eye's rays and one
 * for each mirror bounce; a level holds its hit rows and, for each light, one layer over them. Rows
 * map many-to-one to pixels. Nothing here changes after it was built: an update makes new tiles that
 * share every column it did not touch, so that a canceled update leaves no trace.
 */
package lightning.render.cache;
