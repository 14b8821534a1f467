package lightning.render.relight;

import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * How much one light matters to a picture.
 *
 * @param light   its name
 * @param shines  whether it adds anything at all: it is on and nobody's solo silences it
 * @param picture its part of the picture's mean luminance; 0 of a black picture
 * @param region  the same of a part of the picture
 * @param without what is another in the picture without this light
 */
public record Contribution(String light, boolean shines, double picture, double region, Change without) {

    /**
     * What differs between two pictures of one size.
     *
     * @param values  how many linear values differ in any bit
     * @param largest by how much at most
     * @param shown   how many pixels are displayed in another colour
     */
    public record Change(long values, double largest, long shown) {
        /** Nothing at all. */
        public static final Change NONE = new Change(0, 0, 0);

        /**
         * Compares two pictures.
         *
         * @throws IllegalArgumentException if their sizes differ
         */
        public static Change between(Film before, Film after, ViewTransform view) {
            if (before.width() != after.width() || before.height() != after.height()) {
                throw new IllegalArgumentException("the pictures differ in size");
            }
            if (before.sameBits(after)) {
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
            return new Change(values, largest, shown);
        }

        /** Whether every value has the same bits. */
        public boolean isNone() {
            return values == 0;
        }

        /** Whether every pixel is displayed as before. */
        public boolean isUnseen() {
            return shown == 0;
        }
    }
}
