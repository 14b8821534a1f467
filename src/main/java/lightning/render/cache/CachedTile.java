package lightning.render.cache;

import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeCodes;
import lightning.render.trace.HitRows;

/**
 * All that is known of the centers of one tile's pixels, or of up to 1024 finer samples of some of them. Arrays are
 * never written after construction.
 */
public final class CachedTile {
    /**
     * The first is what the eye sees; what is mirrored in a level's rows follows it, with all that is seen from there, and then
     * what is seen through them. Where nothing is clear, level k is what is seen over k mirrors. All but the first may be missing.
     */
    public final TileLevel[] levels;
    /**
     * Where levels but the first are kept as hit shapes only: for each of them, in the same order, the shape that every ray hit,
     * −1 for none; else empty.
     */
    public final int[][] hitShapes;
    /** What the rays bring that go on from level 0's rows; null where none does. */
    public final BounceImages images;
    /**
     * The colors of the pixels' centers or of the samples: red, green, blue, {@code float[1024]} each. Null for samples at accuracy
     * exact: of those the pixels that they make are kept.
     */
    public final float[][] film;
    /** What anti-aliasing sees of the pixels' centers; null where it does not look for edges. */
    public final EdgeCodes codes;

    public CachedTile(TileLevel[] levels, int[][] hitShapes, BounceImages images, float[][] film, EdgeCodes codes) {
        this.levels = levels;
        this.hitShapes = hitShapes;
        this.images = images;
        this.film = film;
        this.codes = codes;
    }

    /** The largest value of the colors that are kept, linear. */
    float maxValue() {
        float max = 0;
        for (float[] channel : film == null ? new float[0][] : film) {
            for (float value : channel) {
                max = Math.max(max, value);
            }
        }
        return max;
    }

    /** Whether levels but the first are kept as rows, and not as hit shapes. */
    public boolean storesRows() {
        return hitShapes.length == 0;
    }

    /** The rows of the first level. */
    public HitRows rows() {
        return levels[0].rows();
    }

    /** The bytes of rows, layers, stored hits, Cr and codes; the colors are left out. */
    public long bytes() {
        long bytes = 0;
        for (TileLevel level : levels) {
            bytes += level.bytes();
        }
        for (int[] shapes : hitShapes) {
            bytes += 4L * shapes.length;
        }
        return bytes + (images == null ? 0 : images.bytes()) + (codes == null ? 0 : codes.bytes());
    }

    /** The bytes of the colors that are kept. */
    public long colorBytes() {
        return film == null ? 0 : 3L * Float.BYTES * Film.TILE_PIXELS;
    }

    /** The same without its colors. */
    CachedTile withoutColors() {
        return new CachedTile(levels, hitShapes, images, null, codes);
    }

    /** The hit rows of all levels. */
    public long rowCount() {
        long rows = 0;
        for (TileLevel level : levels) {
            rows += level.rows().count;
        }
        return rows;
    }
}
