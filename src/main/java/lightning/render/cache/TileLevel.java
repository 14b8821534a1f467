package lightning.render.cache;

import lightning.render.shading.BranchSums;
import lightning.render.shading.LightLayer;
import lightning.render.trace.HitRows;

/**
 * The hit rows of one level of a tile and the lights' layers over them.
 *
 * @param rows   what the rays hit
 * @param layers one for each light of the scene that the level was lit for, in its order; null where
 *               the light never shone
 * @param branches passing sums that make composing cheaper while one light is edited, or null; void
 *               unless their key is that of the update
 */
public record TileLevel(HitRows rows, LightLayer[] layers, BranchSums branches) {
    // An array in a record: written once by its maker, never after.

    /** A level without sums. */
    public TileLevel(HitRows rows, LightLayer[] layers) {
        this(rows, layers, null);
    }

    /** This level with other sums. */
    public TileLevel withBranchSums(BranchSums sums) {
        return new TileLevel(rows, layers, sums);
    }

    /** This level with other codes for anti-aliasing, {@code int[rows]}, or none. */
    public TileLevel withCode(int[] code) {
        return new TileLevel(rows.withCode(code), layers, branches);
    }

    /** This level with other owners of its rows, or none. */
    public TileLevel withOwner(int[] owner) {
        return new TileLevel(rows.withOwner(owner), layers, branches);
    }

    /** The bytes of all columns, array headers and passing sums left out. */
    public long bytes() {
        long bytes = rows.bytes();
        for (LightLayer layer : layers) {
            bytes += layer == null ? 0 : layer.bytes();
        }
        return bytes;
    }
}
