package lightning.render.match;

import java.util.stream.IntStream;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/**
 * Image that a picture shall resemble, with the weight of each pixel.
 *
 * @param film    linear colors
 * @param weights by pixel, row by row from the top left, ≥ 0; 0 for pixels that do not count
 * @param stays   weights of pixels that shall stay as they are; empty without any
 */
public record ReferenceImage(Film film, float[] weights, float[] stays) {
    // Arrays in a record: written once by their creator, never after.
    /** Largest value of the display below which no rounding hides how bright a pixel is: half a step of 8 bits below white. */
    private static final float CLIPPED = 1 - 0.5f / 255;
    /** Largest relative difference of the ratios of width to height. */
    private static final double MAX_SHAPE_DIFFERENCE = 0.01;

    /** Creates an image without pixels that shall stay. */
    public ReferenceImage(Film film, float[] weights) {
        this(film, weights, new float[0]);
    }

    /** Returns an image all of whose pixels count that are numbers, and finite. */
    public static ReferenceImage of(Film film) {
        float[] weights = new float[film.width() * film.height()];
        for (int i = 0; i < weights.length; i++) {
            weights[i] = isFinite(film, i) ? 1 : 0;
        }
        return new ReferenceImage(film, weights);
    }

    private static boolean isFinite(Film film, int pixel) {
        int x = pixel % film.width();
        int y = pixel / film.width();
        return Float.isFinite(film.red(x, y)) && Float.isFinite(film.green(x, y)) && Float.isFinite(film.blue(x, y));
    }

    /** Returns the number of pixels that are infinite or not a number, and do not count. */
    public int invalidPixels() {
        return (int) IntStream.range(0, weights.length).filter(i -> !isFinite(film, i)).count();
    }

    /** Returns the image without the pixels that a display clips at white, whose brightness is unknown. */
    public ReferenceImage withoutClipped() {
        float[] kept = weights.clone();
        for (int i = 0; i < kept.length; i++) {
            int x = i % film.width();
            int y = i / film.width();
            if (Math.max(film.red(x, y), Math.max(film.green(x, y), film.blue(x, y))) >= CLIPPED) {
                kept[i] = 0;
            }
        }
        return new ReferenceImage(film, kept);
    }

    /**
     * Returns the light that a view transform shows as this image of a display; pixels whose colors the view cannot show do not count.
     *
     * @param view        view transform of the picture
     * @param maxWidth    pixels of the picture; a larger image becomes smaller
     * @param maxHeight   as {@code maxWidth}
     */
    public ReferenceImage beforeView(ViewTransform view, int maxWidth, int maxHeight) {
        ViewTransform shown = view.forOutput();
        ReferenceImage small = film.width() <= maxWidth ? this : reduced(maxWidth, maxHeight);
        return shown.equals(ViewTransform.DEFAULT) ? small : InverseView.apply(small, shown);
    }

    private ReferenceImage reduced(int width, int height) {
        PixelMeans.Means means = new PixelMeans(width, height).of(film, weights);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = means.values()[i % 3][i / 3];
        }
        return new ReferenceImage(Film.ofScanlines(width, height, rgb), means.weights());
    }

    /**
     * Returns the image with only a region of it.
     *
     * @param left  share of the width, 0 to 1; {@code right} too
     * @param top   share of the height, 0 to 1; {@code bottom} too
     */
    public ReferenceImage within(double left, double top, double right, double bottom) {
        float[] kept = weights.clone();
        for (int i = 0; i < kept.length; i++) {
            double x = (i % film.width() + 0.5) / film.width();
            double y = (i / film.width() + 0.5) / film.height();
            if (x < left || x >= right || y < top || y >= bottom) {
                kept[i] = 0;
            }
        }
        return new ReferenceImage(film, kept);
    }

    /** Returns whether it has the shape of a picture, whatever its size. */
    public boolean hasShapeOf(int width, int height) {
        double ratio = (double) film.width() * height / ((double) film.height() * width);
        return Math.abs(ratio - 1) <= MAX_SHAPE_DIFFERENCE;
    }
}
