package lightning.render.shading;

import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeigher;
import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light of a scene.
 *
 * @param structure its paths
 * @param light     light at each gather point: red, green, blue; in the units of the lights' diffuse sum
 * @param edgeLight the same as edge detection sees it; null without edge detection
 */
public record IndirectLight(GatherStructure structure, float[][] light, float @Nullable [][] edgeLight) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Returns the light at one point: red, green, blue.
     *
     * @param weigher weigher of its paths
     */
    public float[] at(SurfacePoint point, RowWeigher weigher) {
        float[][] row = new float[3][1];
        weigher.weigh(point).interpolate(light, row);
        return new float[] {row[0][0], row[1][0], row[2][0]};
    }
}
