package lightning.render.trace;

import lightning.base.math.Vec3;

/**
 * How the normal came about by which a point is shaded, where it is not the surface's own. All of length 1, on the side that is seen.
 *
 * @param geometric the surface's own
 * @param smooth  that between the normals of a mesh's vertices; null where it has none
 * @param bumped  what bump and normal map make of it; null where they tilt nothing
 * @param isBent    whether the last of these was bent towards the viewer, so that what is mirrored leaves the surface
 * @param lift    how far above a flat triangle shadows are asked from, scene units; 0 where its vertices' normals lift no point
 */
public record NormalSteps(Vec3 geometric, Vec3 smooth, Vec3 bumped, boolean isBent, double lift) {}
