package lightning.render.cache;

import java.util.Arrays;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeights;
import lightning.render.shading.fog.BounceColumns;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Hit rows of one level of a tile with one layer per light over them.
 *
 * @param rows hits of the level's rays
 * @param layers layers of the lights of the scene that the level was lit for, in order; null for lights that were never on
 * @param weights weights of gather points for the rows
 * @param fog optional light in fog along the rays to these rows
 */
public record TileLevel(HitRows rows, LightLayer[] layers, @Nullable RowWeights weights, @Nullable BounceColumns fog) {
    // An array in a record: written once by its creator.

    /** Creates a level without weights and light in fog. */
    public TileLevel(HitRows rows, LightLayer[] layers) {
        this(rows, layers, null, null);
    }

    /** Returns this level with other owners of its rows, or none. */
    public TileLevel withOwner(int @Nullable [] owner) {
        return new TileLevel(rows.withOwner(owner), layers, weights, null);
    }

    /** Returns this level with other weights of gather points, or none. */
    public TileLevel withWeights(@Nullable RowWeights to) {
        return to == weights ? this : new TileLevel(rows, layers, to, fog);
    }

    /** Returns this level with other light in fog along the rays to it, or none. */
    public TileLevel withFog(@Nullable BounceColumns to) {
        return to == fog ? this : new TileLevel(rows, layers, weights, to);
    }

    /** Returns whether another level has the same arrays of layers. */
    boolean sharesLayers(TileLevel other) {
        return Arrays.equals(layers, other.layers, (x, y) -> x == y ? 0 : 1);
    }

    /** Returns whether this level has the weights of a structure's gather points. */
    public boolean hasWeightsOf(GatherStructure structure) {
        return weights != null && weights.structure() == structure;
    }

    /** Returns the bytes of all columns without array headers. */
    public long bytes() {
        long bytes = rows.bytes();
        for (LightLayer layer : layers) {
            bytes += layer == null ? 0 : layer.bytes();
        }
        return bytes + (weights == null ? 0 : weights.bytes())
                + (fog == null ? 0 : fog.bytes());
    }
}
