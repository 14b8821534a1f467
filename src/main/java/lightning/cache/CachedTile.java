package lightning.cache;

import lightning.trace.HitRows;

/**
 * All that is known of one tile. Arrays are never written after construction.
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
    /** The tile of the film: red, green, blue, {@code float[1024]} each. */
    public final float[][] film;

    public CachedTile(TileLevel[] levels, int[][] hitShapes, float[][] mirrored, float[][] film) {
        this.levels = levels;
        this.hitShapes = hitShapes;
        this.mirrored = mirrored;
        this.film = film;
    }

    /** The largest value in the tile of the film, linear. */
    float brightest() {
        float brightest = 0;
        for (float[] channel : film) {
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

    /** The bytes of rows, layers, stored hits and Cr; the film is left out. */
    public long bytes() {
        long bytes = 0;
        for (TileLevel level : levels) {
            bytes += level.bytes();
        }
        for (int[] shapes : hitShapes) {
            bytes += 4L * shapes.length;
        }
        return bytes + (mirrored == null ? 0 : 12L * mirrored[0].length);
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
