package lightning.render.shading;

import java.util.Arrays;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeigher;
import lightning.render.gather.RowWeights;
import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light of a scene.
 *
 * @param structure its paths
 * @param light     light at each gather point in the units of the lights' diffuse sum, and at each reflection point, as {@link
 *                  IndirectSolver#solve}
 * @param edgeLight the same as edge detection sees it; null without edge detection
 */
public record IndirectLight(GatherStructure structure, float[][] light, float @Nullable [][] edgeLight) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Returns the light at one point: red, green, blue; then, if there are blurred reflections, the six values that it reflects.
     *
     * @param weigher weigher of its paths
     */
    public float[] at(SurfacePoint point, RowWeigher weigher) {
        float[][] row = new float[light.length][1];
        RowWeights weights = weigher.weigh(point);
        weights.interpolate(light, row);
        weights.interpolateReflected(light, Arrays.copyOfRange(row, 3, row.length));
        float[] values = new float[row.length];
        for (int c = 0; c < values.length; c++) {
            values[c] = row[c][0];
        }
        return values;
    }
}
