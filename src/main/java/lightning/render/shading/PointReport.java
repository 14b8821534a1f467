package lightning.render.shading;

import java.util.List;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;

/**
 * The lighting equation at one point with all its parts.
 *
 * @param hit        what the ray met; null where it met nothing and brought the background
 * @param passedCutouts     the primitives through whose holes the ray came, each once; none where nobody looked
 * @param normals   how its normal came about; null where it is the surface's own
 * @param color     the color that the ray brings, linear, {@code float[3]}
 * @param ambient   ka·ambience·(1 − kr), linear, {@code float[3]}
 * @param lights    one for each light of the scene, in its order
 * @param refracted what the refracted ray brings; null if nothing is seen through the material, the surface mirrors all, or the depth
 *                  ends here
 * @param reflected what the mirrored ray brings; null if the material does not mirror or the depth ends here
 */
public record PointReport(SurfacePoint hit, List<Integer> passedCutouts, NormalSteps normals, float[] color, float[] ambient,
        List<LightReport> lights,
        PointReport reflected,
        PointReport refracted) {
    /** Whether the ray met nothing. */
    public boolean isBackground() {
        return hit == null;
    }
}
