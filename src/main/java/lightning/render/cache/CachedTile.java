package lightning.render.cache;

import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.fog.FogTile;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Cached data of one tile's pixel centers, or of up to 1024 finer samples of some pixels. Arrays are never written after
 * construction.
 *
 * @param levels    levels in pre-order: the camera rays' hits first, then for each level its reflected subtree, then its refracted one.
 *                  Without transparent materials, level k is seen after k reflections. All levels but the first may be missing
 * @param hitShapes for levels that are stored only as hit shapes: per level, in the same order, the shape that each ray hit, −1 for none;
 *                  otherwise empty
 * @param images    colors that level 0's secondary rays show, where mirrors may show an earlier scene or its levels are not stored;
 *                  otherwise null
 * @param film      colors of the pixel centers or samples: red, green, blue, {@code float[1024]} each. Null for samples at accuracy exact,
 *                  for which only the resulting pixels are stored
 * @param films     films of the pixel centers; null if they are not kept, and for samples
 * @param edges     colors by which edges are detected; null if they are not
 * @param fog       fog before the first level's rows; null if the air is clear
 */
public record CachedTile(TileLevel[] levels, int[][] hitShapes, @Nullable BounceImages images, float @Nullable [][] film,
        @Nullable StoredFilms films, @Nullable EdgeColors edges, @Nullable FogTile fog) {
    /** Returns the maximum of the stored colors, linear. */
    float maxValue() {
        float max = 0;
        for (float[] channel : film == null ? new float[0][] : film) {
            for (float value : channel) {
                max = Math.max(max, value);
            }
        }
        return max;
    }

    /** Returns whether the deeper levels are stored as rows, false for hit shapes. */
    public boolean storesRows() {
        return hitShapes.length == 0;
    }

    /** Returns the rows of the first level. */
    public HitRows rows() {
        return levels[0].rows();
    }

    /** Returns the bytes of rows, layers, stored hits, Cr, edge colors and fog, without colors. */
    public long bytes() {
        long bytes = 0;
        for (TileLevel level : levels) {
            bytes += level.bytes();
        }
        for (int[] shapes : hitShapes) {
            bytes += 4L * shapes.length;
        }
        return bytes + (images == null ? 0 : images.bytes()) + (edges == null ? 0 : edges.bytes()) + (fog == null ? 0 : fog.bytes());
    }

    /** Returns the bytes of the stored colors and films. */
    public long colorBytes() {
        return (film == null ? 0 : 3L * Float.BYTES * Film.TILE_PIXELS) + (films == null ? 0 : films.bytes());
    }

    /** Returns the number of hit rows of all levels. */
    public long rowCount() {
        long rows = 0;
        for (TileLevel level : levels) {
            rows += level.rows().count;
        }
        return rows;
    }
}
