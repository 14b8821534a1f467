package lightning.render.relight;

import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * How much one light matters to a picture.
 *
 * @param light   its name
 * @param shines  whether it adds anything at all: it is on and nobody's solo silences it
 * @param imageShare its part of the picture's mean luminance; 0 of a black picture
 * @param regionShare  the same of a part of the picture
 * @param changeWhenOff what is another in the picture without this light
 */
public record LightContribution(String light, boolean shines, double imageShare, double regionShare, FilmChange changeWhenOff) {

    /**
     * What differs between two pictures of one size.
     *
     * @param changedValues  how many linear values differ in any bit
     * @param maxDifference by how much at most
     * @param changedPixels   how many pixels are displayed in another color
     */
    public record FilmChange(long changedValues, double maxDifference, long changedPixels) {
        /** Nothing at all. */
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
            int[] seenBefore = view.toPixels(before);
            int[] seenAfter = view.toPixels(after);
            long shown = 0;
            for (int i = 0; i < seenBefore.length; i++) {
                shown += seenBefore[i] == seenAfter[i] ? 0 : 1;
            }
            return new FilmChange(values, largest, shown);
        }

        /** Whether every value has the same bits. */
        public boolean isNone() {
            return changedValues == 0;
        }

        /** Whether every pixel is displayed as before. */
        public boolean isInvisible() {
            return changedPixels == 0;
        }
    }
}
