package lightning.render.trace;

import lightning.base.math.Vec3;

/**
 * How the normal came about by which a point is shaded, where it is not the surface's own. All of length 1, on the side that is seen.
 *
 * @param surface the surface's own
 * @param smooth  that between the normals of a mesh's vertices; null where it has none
 * @param mapped  what bump and normal map make of it; null where they tilt nothing
 * @param bent    whether the last of these was bent towards the viewer, so that what is mirrored leaves the surface
 * @param lift    how far above a flat triangle shadows are asked from, scene units; 0 where its vertices' normals lift no point
 */
public record NormalSteps(Vec3 surface, Vec3 smooth, Vec3 mapped, boolean bent, double lift) {}
