package lightning.render.image;

import java.nio.file.Path;

/**
 * A table of colors for other colors, as files of the Cube LUT Specification 1.0 (Adobe, 2013) hold it: one for each channel, or a lattice
 * of all three.
 *
 * <p>Between the entries of a channel's table it is linear; between the points of a lattice tetrahedral: each cell is cut into the six
 * tetrahedra about its gray diagonal (Kasson, Nin, Plouffe and Hafner, Performing color space conversions with three-dimensional linear
 * interpolation, Journal of Electronic Imaging 4(3), 1995), so that grays depend on grays alone. What lies outside the domain is moved to
 * its border, channel by channel.
 */
public final class CubeLut {
    /** The most entries of a channel's table. */
    public static final int MAX_ENTRIES = 65536;
    /** The most points along an edge of a lattice. */
    public static final int MAX_POINTS = 129;

    private final Path file;
    private final boolean is3d;
    private final int size;
    private final float[] colors;
    private final float[] min;
    private final double[] scale;

    /**
     * @param lattice whether {@code colors} is {@code float[3 * size³]}, red first and fastest, then green, then blue; else {@code float[3 * size]}
     * @param min     of each channel's domain, below that of {@code max}
     */
    public CubeLut(Path file, boolean lattice, int size, float[] colors, float[] min, float[] max) {
        this.file = file;
        this.is3d = lattice;
        this.size = size;
        this.colors = colors;
        this.min = min.clone();
        scale = new double[3];
        for (int c = 0; c < 3; c++) {
            scale[c] = (size - 1) / ((double) max[c] - min[c]);
        }
    }

    /** What it was read from. */
    public Path file() {
        return file;
    }

    /** As in {@code 33 × 33 × 33}. */
    public String sizeText() {
        return is3d ? size + " × " + size + " × " + size : "3 × " + size;
    }

    /**
     * Looks a color up.
     *
     * @param color {@code double[3]}: red, green and blue, which become those of the table; what is no number counts as the domain's least
     */
    void apply(double[] color) {
        for (int c = 0; c < 3; c++) {
            double at = (color[c] - min[c]) * scale[c];
            // What is no number is not above 0.
            color[c] = at > 0 ? Math.min(at, size - 1) : 0;
        }
        if (is3d) {
            tetrahedral(color);
        } else {
            for (int c = 0; c < 3; c++) {
                int cell = Math.min((int) color[c], size - 2);
                double share = color[c] - cell;
                color[c] = colors[3 * cell + c] * (1 - share) + colors[3 * cell + 3 + c] * share;
            }
        }
    }

    /** From a corner of the cell along the axes, the one of the largest share first, to the corner across. */
    private void tetrahedral(double[] color) {
        int r = Math.min((int) color[0], size - 2);
        int g = Math.min((int) color[1], size - 2);
        int b = Math.min((int) color[2], size - 2);
        double x = color[0] - r;
        double y = color[1] - g;
        double z = color[2] - b;
        int alongR = 3;
        int alongG = 3 * size;
        int alongB = 3 * size * size;
        int first = x >= y ? x >= z ? alongR : alongB : y >= z ? alongG : alongB;
        int last = x < y ? x < z ? alongR : alongB : y < z ? alongG : alongB;
        double max = Math.max(x, Math.max(y, z));
        double min = Math.min(x, Math.min(y, z));
        double middle = Math.max(Math.min(x, y), Math.min(Math.max(x, y), z));
        int corner = r * alongR + g * alongG + b * alongB;
        int farCorner = corner + alongR + alongG + alongB;
        for (int c = 0; c < 3; c++) {
            color[c] = colors[corner + c] * (1 - max) + colors[corner + first + c] * (max - middle)
                    + colors[farCorner - last + c] * (middle - min) + colors[farCorner + c] * min;
        }
    }
}
