package lightning.render.shading;

import lightning.render.gather.RowWeights;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light of a level's rows.
 *
 * @param weights weights of gather points
 * @param light   light at each gather point and reflection point, as {@link IndirectLight#light}
 */
public record IndirectRows(RowWeights weights, float[] @Nullable [][] light) {
    // An array in a record: written once by its creator, never after.
}
