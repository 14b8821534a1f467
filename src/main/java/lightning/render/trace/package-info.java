/**
 * Visibility: the rays of a tile, and what they leave behind: which shape each meets first, and where.
 *
 * <p>Everything here happens in <em>render space</em>: the scene moved, in double precision, so that
 * the camera stands at the origin. A hit is decided by one function of ray and shape
 * ({@link lightning.render.trace.solid.SolidGeometry}), whoever asks; boxes and packets may only reject. Among equal
 * distances the lowest shape index wins. A miss is a distance of positive infinity; no function
 * returns NaN.
 *
 * <p>What a hit leaves behind is rounded to float in one place ({@link lightning.render.trace.primitive.SurfaceHit}):
 * all shading is computed from those floats, which is what makes a re-render equal to a full trace.
 */
package lightning.render.trace;
