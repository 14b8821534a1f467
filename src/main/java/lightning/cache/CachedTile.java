package lightning.cache;

import java.util.Arrays;
import lightning.image.Film;
import lightning.shading.EdgeCodes;
import lightning.trace.HitRows;

/**
 * All that is known of the centres of one tile's pixels, or of up to 1024 finer samples of some of them. Arrays are
 * never written after construction.
 */
public final class CachedTile {
    /** Level 0 is what the eye sees; level k what is seen over k mirrors. Later levels may be missing. */
    public final TileLevel[] levels;
    /**
     * Where mirror levels are kept as hit shapes only: for each of them the shape that every ray hit,
     * −1 for none; else empty.
     */
    public final int[][] hitShapes;
    /** Cr of level 0's reflective rows: red, green, blue columns; null where it has none. */
    public final float[][] mirrored;
    /**
     * The colours of the pixels' centres or of the samples: red, green, blue, {@code float[1024]} each. Null for samples at accuracy
     * exact: of those the pixels that they make are kept.
     */
    public final float[][] film;
    /** What anti-aliasing sees of the pixels' centres; null where it does not look for edges. */
    public final EdgeCodes codes;

    public CachedTile(TileLevel[] levels, int[][] hitShapes, float[][] mirrored, float[][] film, EdgeCodes codes) {
        this.levels = levels;
        this.hitShapes = hitShapes;
        this.mirrored = mirrored;
        this.film = film;
        this.codes = codes;
    }

    /** What is kept of Cr of a first level's rows: copies of its red, green and blue columns, just long enough. */
    public static float[][] mirrored(HitRows rows, float[][] cr) {
        return Arrays.stream(cr).map(column -> Arrays.copyOf(column, HitRows.padded(rows.reflective))).toArray(float[][]::new);
    }

    /** The largest value of the colours that are kept, linear. */
    float brightest() {
        float brightest = 0;
        for (float[] channel : film == null ? new float[0][] : film) {
            for (float value : channel) {
                brightest = Math.max(brightest, value);
            }
        }
        return brightest;
    }

    /** The rows of the first level. */
    public HitRows rows() {
        return levels[0].rows();
    }

    /** The bytes of rows, layers, stored hits, Cr and codes; the colours are left out. */
    public long bytes() {
        long bytes = 0;
        for (TileLevel level : levels) {
            bytes += level.bytes();
        }
        for (int[] shapes : hitShapes) {
            bytes += 4L * shapes.length;
        }
        return bytes + (mirrored == null ? 0 : 12L * mirrored[0].length) + (codes == null ? 0 : codes.bytes());
    }

    /** The bytes of the colours that are kept. */
    public long colorBytes() {
        return film == null ? 0 : 3L * Float.BYTES * Film.TILE_PIXELS;
    }

    /** The same without its colours. */
    CachedTile withoutColors() {
        return new CachedTile(levels, hitShapes, mirrored, null, codes);
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
