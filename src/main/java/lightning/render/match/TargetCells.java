package lightning.render.match;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.RefusalException;

/**
 * A reference over the cells of a grid.
 *
 * @param values  {@code float[channel][cell]}
 * @param weights weight of each cell's squared difference: its own, divided by the square of the reference's luminance, at least 0, plus a twentieth of
 *                its mean, so that relative differences count, as eyes see them
 * @param total   sum of the cells' own weights, of all channels
 */
record TargetCells(float[][] values, double[] weights, double total) {
    // Arrays in a record: written once by their creator, never after.
    /** Share of the mean luminance that is added to each: darker pixels count as absolute differences. */
    private static final double FLOOR = 0.05;
    private static final double[] LUMINANCE = {0.2126, 0.7152, 0.0722};

    /**
     * Returns the cells of a reference, and after them those that shall stay, if there are any.
     *
     * @throws IllegalArgumentException if no cell counts
     */
    static List<TargetCells> all(ReferenceImage reference, PixelMeans grid) {
        TargetCells counting =
                of(reference, grid).orElseThrow(() -> new RefusalException("no pixel of the reference counts"));
        Optional<TargetCells> staying = reference.stays().length == 0 ? Optional.empty()
                : of(new ReferenceImage(reference.film(), reference.stays()), grid);
        return Stream.concat(Stream.of(counting), staying.stream()).toList();
    }

    /** Returns the cells that count; empty if none does. */
    private static Optional<TargetCells> of(ReferenceImage reference, PixelMeans grid) {
        PixelMeans.Means target = grid.of(reference.film(), reference.weights());
        double[] weights = new double[target.weights().length];
        double sum = 0;
        double total = 0;
        for (int i = 0; i < weights.length; i++) {
            sum += target.weights()[i] * luminance(target.values(), i);
            total += target.weights()[i];
        }
        if (total == 0) {
            return Optional.empty();
        }
        for (int i = 0; i < weights.length; i++) {
            double unit = luminance(target.values(), i) + FLOOR * sum / total;
            weights[i] = unit == 0 ? target.weights()[i] : target.weights()[i] / (unit * unit);
        }
        return Optional.of(new TargetCells(target.values(), weights, 3 * total));
    }

    private static double luminance(float[][] image, int i) {
        return Math.max(0, luminance(image[0][i], image[1][i], image[2][i]));
    }

    static double luminance(double red, double green, double blue) {
        return LUMINANCE[0] * red + LUMINANCE[1] * green + LUMINANCE[2] * blue;
    }

    /** Returns the mean luminance of each channel of an image. */
    static double[] means(float[][] image) {
        double[] means = new double[3];
        for (int c = 0; c < 3; c++) {
            for (float value : image[c]) {
                means[c] += LUMINANCE[c] * value / image[c].length;
            }
        }
        return means;
    }
}
