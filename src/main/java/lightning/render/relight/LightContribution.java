package lightning.render.relight;

import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Contribution of one light to a picture.
 *
 * @param light         name of the light
 * @param shines        true if it contributes at all: it is on and not muted by a solo light
 * @param imageShare    its part of the picture's mean luminance; 0 for a black picture
 * @param regionShare   its part of a region's mean luminance
 * @param changeWhenOff change of the picture when the light is switched off
 */
public record LightContribution(String light, boolean shines, double imageShare, double regionShare, FilmChange changeWhenOff) {

    /**
     * Difference between two pictures of one size.
     *
     * @param changedValues number of linear values that differ in any bit
     * @param maxDifference largest difference of a linear value
     * @param changedPixels number of pixels with another display color
     */
    public record FilmChange(long changedValues, double maxDifference, long changedPixels) {
        /** No difference. */
        public static final FilmChange NONE = new FilmChange(0, 0, 0);

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
            for (int i = 0; i < pixelsBefore.length; i++) {
                shown += pixelsBefore[i] == pixelsAfter[i] ? 0 : 1;
            }
            return new FilmChange(values, largest, shown);
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
