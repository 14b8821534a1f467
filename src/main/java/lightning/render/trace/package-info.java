/**
 * Visibility: traces the rays of a tile and stores their nearest hits as rows.
 *
 * <p>All coordinates are in <em>render space</em>: the scene translated, in double precision, so that the camera is at the
 * origin. One function of ray and shape decides every hit ({@link lightning.render.trace.solid.SolidGeometry}); boxes and
 * packets may only reject. Among equal distances the lowest shape index wins. A miss is a distance of positive infinity; no
 * function returns NaN.
 *
 * <p>Hits are rounded to float in one place ({@link lightning.render.trace.primitive.SurfaceHit}). All shading is computed from
 * those floats, which makes a re-render equal to a full trace.
 */
@NullMarked
package lightning.render.trace;

import org.jspecify.annotations.NullMarked;
