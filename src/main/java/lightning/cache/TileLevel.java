package lightning.cache;

import lightning.shading.LightLayer;
import lightning.trace.HitRows;

/**
 * The hit rows of one level of a tile and the lights' layers over them.
 *
 * @param rows   what the rays hit
 * @param layers one for each light of the scene that the level was lit for, in its order; null where
 *               the light never shone
 */
public record TileLevel(HitRows rows, LightLayer[] layers) {
    // An array in a record: written once by its maker, never after.

    /** The bytes of all columns, array headers left out. */
    public long bytes() {
        long bytes = rows.bytes();
        for (LightLayer layer : layers) {
            bytes += layer == null ? 0 : layer.bytes();
        }
        return bytes;
    }
}
