package lightning.render.shading.fog;

import lightning.render.fog.FogMedium;
import org.jspecify.annotations.Nullable;

/**
 * Fog before the surfaces of a tile's pixel centers or samples.
 *
 * @param medium        fog that it was computed for
 * @param transmittance share of the surface's light that passes: {@code float[1024]}
 * @param sources       light of the picture's fog that each column of {@code scattered} was looked up in; null for none
 * @param scattered     light that the fog scatters of each light of weight 1: {@code float[1024]} each; null for none
 */
public record FogTile(FogMedium medium, float[] transmittance, @Nullable FogLight[] sources,
        float[] @Nullable [] scattered) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns the bytes of the columns. */
    public long bytes() {
        long bytes = 4L * transmittance.length;
        for (float[] column : scattered) {
            bytes += column == null || FogLookup.isDark(column) ? 0 : 4L * column.length;
        }
        return bytes;
    }
}
