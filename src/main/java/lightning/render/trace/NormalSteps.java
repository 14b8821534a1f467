package lightning.render.trace;

import lightning.base.math.Vec3;
import org.jspecify.annotations.Nullable;

/**
 * Steps from the geometric normal to the shading normal of a point. All normals have length 1 and face the visible side.
 *
 * @param geometric normal of the surface
 * @param smooth interpolated vertex normal of a mesh; null if it has none
 * @param bumped normal after bump and normal mapping; null if there is none
 * @param isBent true if the last of these was bent toward the viewer so that reflected rays leave the surface
 * @param lift height above a flat triangle at which shadow rays start, scene units; 0 if vertex normals lift no point
 */
public record NormalSteps(Vec3 geometric, @Nullable Vec3 smooth, @Nullable Vec3 bumped, boolean isBent, double lift) {}
