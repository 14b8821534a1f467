package lightning.render.image;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.base.text.RefusalException;

/**
 * ꟻLIP error metric: the perceived difference when a viewer alternates between two pictures at a given distance from the screen, from
 * 0 (indistinguishable) to 1. LDR-ꟻLIP as defined by Andersson, Nilsson, Akenine-Möller, Oskarsson,
 * Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020; every constant is from there.
 *
 * <p>Both pictures are displayed ({@link ViewTransform#DEFAULT}) and blurred like the eye's image. Each pixel is compared by color (HyAB
 * distance of Hunt-adjusted L*a*b*, compressed to 0…1) and by features, the edges and points that only one picture has. The error is
 * {@code color^(1 − features)}.
 *
 * <pre>{@code
 * double error = Flip.mean(updated, traced);
 * }</pre>
 */
public final class Flip {

    /** Pixels per degree for the definition's observer, 0.7 m from a screen 0.7 m wide with 3840 pixels a row: 67.02. */
    public static final double PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * Math.PI / 180;

    /** Large enough that margins cost little, small enough that the planes of a band stay in the cache. */
    private static final int BAND_ROWS = 64;

    private static final double COLOR_EXPONENT = 0.7;
    /** Color differences up to this share of the largest one … */
    private static final double COMMON_SHARE = 0.4;
    /** … take this share of the scale. */
    private static final double COMMON_SCALE = 0.95;
    private static final double MAX_DISTANCE = Math.pow(maxColorDistance(), COLOR_EXPONENT);

    private Flip() {}

    /**
     * Returns the mean error over all pixels, 0…1, at {@link #PIXELS_PER_DEGREE}.
     *
     * @throws RefusalException if the sizes of the films differ
     */
    public static double mean(Film a, Film b) {
        return mean(a, b, PIXELS_PER_DEGREE);
    }

    /**
     * Returns the mean error over all pixels, 0…1.
     *
     * @param pixelsPerDegree pixels per degree of the visual field, 1 to 1000
     * @throws RefusalException if the sizes of the films differ, or {@code pixelsPerDegree} is NaN or outside its range
     */
    public static double mean(Film a, Film b, double pixelsPerDegree) {
        double sum = 0;
        for (float error : errors(a, b, pixelsPerDegree)) {
            sum += error;
        }
        return sum / ((double) a.width() * a.height());
    }

    /**
     * Returns the error of each pixel, 0…1, as {@code float[width * height]}, the top row first.
     *
     * @param pixelsPerDegree pixels per degree of the visual field, 1 to 1000
     * @throws RefusalException if the sizes of the films differ, or {@code pixelsPerDegree} is NaN or outside its range
     */
    public static float[] errors(Film a, Film b, double pixelsPerDegree) {
        Difference.requireSameSize(a, b);
        if (!(pixelsPerDegree >= 1 && pixelsPerDegree <= 1000)) {
            throw new RefusalException("pixels per degree must be from 1 to 1000, was " + pixelsPerDegree);
        }
        int[] pixelsA = ViewTransform.DEFAULT.toPixels(a);
        int[] pixelsB = ViewTransform.DEFAULT.toPixels(b);
        float[] errors = new float[pixelsA.length];
        EyeFilters filters = new EyeFilters(pixelsPerDegree);
        IntStream.range(0, (a.height() + BAND_ROWS - 1) / BAND_ROWS).parallel().forEach(band -> {
            int top = band * BAND_ROWS;
            int rows = Math.min(BAND_ROWS, a.height() - top);
            if (!haveSamePixels(pixelsA, pixelsB, a.width(), top - filters.radius, top + rows + filters.radius)) {
                compare(new FlipBand(pixelsA, a.width(), a.height(), top, rows, filters),
                        new FlipBand(pixelsB, a.width(), a.height(), top, rows, filters), errors, top * a.width());
            }
        });
        return errors;
    }

    private static boolean haveSamePixels(int[] a, int[] b, int width, int from, int to) {
        int start = Math.max(from, 0) * width;
        int end = Math.min(to * width, a.length);
        return Arrays.equals(a, start, end, b, start, end);
    }

    private static void compare(FlipBand a, FlipBand b, float[] errors, int start) {
        for (int i = 0; i < a.edges.length; i++) {
            double color = compress(Math.pow(distance(a.lab, b.lab, i, i), COLOR_EXPONENT));
            double feature = Math.max(Math.abs(a.edges[i] - b.edges[i]), Math.abs(a.points[i] - b.points[i]));
            errors[start + i] = (float) Math.pow(color, 1 - Math.sqrt(feature / Math.sqrt(2)));
        }
    }

    /** Returns the HyAB distance: lightness difference plus chroma distance. */
    private static double distance(double[][] a, double[][] b, int i, int j) {
        double greenRed = a[1][i] - b[1][j];
        double blueYellow = a[2][i] - b[2][j];
        return Math.abs(a[0][i] - b[0][j]) + Math.sqrt(greenRed * greenRed + blueYellow * blueYellow);
    }

    /** Maps a color difference ≥ 0 to 0…1; common differences use most of the scale. */
    private static double compress(double difference) {
        double common = COMMON_SHARE * MAX_DISTANCE;
        return difference < common
                ? COMMON_SCALE / common * difference
                : COMMON_SCALE + (difference - common) / (MAX_DISTANCE - common) * (1 - COMMON_SCALE);
    }

    /** Returns the largest distance of two displayable colors. */
    private static double maxColorDistance() {
        double[][] lab = new double[3][2];
        OpponentColor.writeHuntLab(0, 1, 0, lab, 0);
        OpponentColor.writeHuntLab(0, 0, 1, lab, 1);
        return distance(lab, lab, 0, 1);
    }
}
