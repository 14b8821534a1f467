package lightning.render.relight;

import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Difference between two pictures of one size.
 *
 * @param changedValues number of linear values that differ in any bit
 * @param maxDifference largest difference of a linear value
 * @param changedPixels number of pixels with another display color
 * @param noticedShare  share of pixels whose display color changes noticeably: by at least {@link #NOTICED_LEVELS} of 255 levels
 * @param noticedStops  change of luminance, in stops, at the noticed pixel where it is largest; 0 if there is none
 */
public record FilmChange(long changedValues, double maxDifference, long changedPixels, double noticedShare, double noticedStops) {
    /** No difference. */
    public static final FilmChange NONE = new FilmChange(0, 0, 0, 0, 0);

    /** Levels of a color channel that an observer notices between two pictures shown in turns. */
    public static final int NOTICED_LEVELS = 4;
    /** Luminance that is added to both pictures, relative to white, so that black has a limit of stops. */
    private static final double BLACK = 1.0 / 1024;

    /**
     * Compares two pictures.
     *
     * @throws IllegalArgumentException if their sizes differ
     */
    public static FilmChange between(Film before, Film after, ViewTransform view) {
        if (before.width() != after.width() || before.height() != after.height()) {
            throw new IllegalArgumentException("the pictures differ in size");
        }
        Counter counter = new Counter(view);
        for (int tile = 0; tile < before.tileCount(); tile++) {
            counter.start(before, tile, new float[][] {before.red(tile), before.green(tile), before.blue(tile)});
            counter.add(new float[][] {after.red(tile), after.green(tile), after.blue(tile)});
        }
        return counter.total(before);
    }

    /** Returns whether every value has the same bits. */
    public boolean isNone() {
        return changedValues == 0;
    }

    /** Returns whether every pixel has the same display color. */
    public boolean isInvisible() {
        return changedPixels == 0;
    }

    /** Counts differences tile by tile. Use one for each thread. */
    static final class Counter {
        private final ViewTransform view;
        private float[][] before = {};
        private int[] pixelsBefore = {};
        private int columns;
        private long values;
        private double largest;
        private long shown;
        private long noticed;
        private double stops;

        Counter(ViewTransform view) {
            this.view = view;
        }

        /** Sets the tile of a film of this size that is compared next. @param colors its red, green and blue before */
        void start(Film film, int tile, float[][] colors) {
            columns = Math.min(Film.TILE_SIZE, film.width() - tile % film.tilesX() * Film.TILE_SIZE);
            int rows = Math.min(Film.TILE_SIZE, film.height() - tile / film.tilesX() * Film.TILE_SIZE);
            before = colors;
            pixelsBefore = pixels(before, rows);
        }

        /** Sets the same tile as another counter. */
        void start(Counter other) {
            columns = other.columns;
            before = other.before;
            pixelsBefore = other.pixelsBefore;
        }

        private int[] pixels(float[][] tile, int rows) {
            int[] pixels = new int[columns * rows];
            view.packTile(tile[0], tile[1], tile[2], 0, 0, columns, pixels);
            return pixels;
        }

        /** Compares the tile. @param after its red, green and blue, {@code float[3][1024]} */
        void add(float[][] after) {
            long valuesBefore = values;
            int rows = pixelsBefore.length / columns;
            for (int c = 0; c < 3; c++) {
                for (int y = 0; y < rows; y++) {
                    for (int i = y * Film.TILE_SIZE; i < y * Film.TILE_SIZE + columns; i++) {
                        if (Float.floatToRawIntBits(before[c][i]) != Float.floatToRawIntBits(after[c][i])) {
                            values++;
                            largest = Math.max(largest, Math.abs((double) before[c][i] - after[c][i]));
                        }
                    }
                }
            }
            if (values > valuesBefore) {
                addPixels(after, pixels(after, rows));
            }
        }

        private void addPixels(float[][] after, int[] pixelsAfter) {
            for (int p = 0; p < pixelsAfter.length; p++) {
                shown += pixelsBefore[p] == pixelsAfter[p] ? 0 : 1;
                if (levels(pixelsBefore[p], pixelsAfter[p]) >= NOTICED_LEVELS) {
                    noticed++;
                    int i = p / columns * Film.TILE_SIZE + p % columns;
                    addStops(stops(luminance(before, i) * view.gain(), luminance(after, i) * view.gain()));
                }
            }
        }

        private void addStops(double change) {
            stops = Math.abs(change) > Math.abs(stops) || change == -stops && change > 0 ? change : stops;
        }

        /** Adds what another counter counted. */
        void add(Counter other) {
            values += other.values;
            largest = Math.max(largest, other.largest);
            shown += other.shown;
            noticed += other.noticed;
            addStops(other.stops);
        }

        /** Returns the difference of all tiles of a film. */
        FilmChange total(Film film) {
            return new FilmChange(values, largest, shown, noticed / ((double) film.width() * film.height()), stops);
        }

        /** Returns the largest difference of a channel of two display colors. */
        private static int levels(int a, int b) {
            int red = Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF));
            int green = Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF));
            return Math.max(Math.max(red, green), Math.abs((a & 0xFF) - (b & 0xFF)));
        }

        private static double luminance(float[][] tile, int i) {
            return 0.2126 * tile[0][i] + 0.7152 * tile[1][i] + 0.0722 * tile[2][i];
        }

        private static double stops(double before, double after) {
            return Math.log((Math.max(after, 0) + BLACK) / (Math.max(before, 0) + BLACK)) / Math.log(2);
        }
    }
}
