package lightning.render.relight;

import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Contribution;

/**
 * Contribution of one light to a picture.
 *
 * @param light         the light or environment
 * @param shines        true if it contributes at all: it is on and not muted by a solo light
 * @param imageShare    its part of the picture's mean luminance; 0 for a black picture
 * @param regionShare   its part of a region's mean luminance
 * @param changeWhenOff change of the picture when the light is switched off
 */
public record LightContribution(Contribution light, boolean shines, double imageShare, double regionShare, FilmChange changeWhenOff) {

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
            if (before.hasSameBits(after)) {
                return NONE;
            }
            float[] a = before.toScanlines();
            float[] b = after.toScanlines();
            long values = 0;
            double largest = 0;
            for (int i = 0; i < a.length; i++) {
                if (Float.floatToRawIntBits(a[i]) != Float.floatToRawIntBits(b[i])) {
                    values++;
                    largest = Math.max(largest, Math.abs((double) a[i] - b[i]));
                }
            }
            int[] pixelsBefore = view.toPixels(before);
            int[] pixelsAfter = view.toPixels(after);
            long shown = 0;
            long noticed = 0;
            double stops = 0;
            for (int i = 0; i < pixelsBefore.length; i++) {
                shown += pixelsBefore[i] == pixelsAfter[i] ? 0 : 1;
                if (levels(pixelsBefore[i], pixelsAfter[i]) >= NOTICED_LEVELS) {
                    noticed++;
                    double change = stops(luminance(a, i) * view.gain(), luminance(b, i) * view.gain());
                    stops = Math.abs(change) > Math.abs(stops) ? change : stops;
                }
            }
            return new FilmChange(values, largest, shown, (double) noticed / pixelsBefore.length, stops);
        }

        /** Returns the largest difference of a channel of two display colors. */
        private static int levels(int a, int b) {
            int red = Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF));
            int green = Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF));
            return Math.max(Math.max(red, green), Math.abs((a & 0xFF) - (b & 0xFF)));
        }

        private static double luminance(float[] rgb, int pixel) {
            return new Rgb(rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]).luminance();
        }

        private static double stops(double before, double after) {
            return Math.log((Math.max(after, 0) + BLACK) / (Math.max(before, 0) + BLACK)) / Math.log(2);
        }

        /** Returns whether every value has the same bits. */
        public boolean isNone() {
            return changedValues == 0;
        }

        /** Returns whether every pixel has the same display color. */
        public boolean isInvisible() {
            return changedPixels == 0;
        }
    }
}
