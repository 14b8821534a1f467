package lightning.render.image;

import java.nio.file.Path;
import java.util.Optional;

/**
 * Color lookup table of the Cube LUT Specification 1.0 (Adobe, 2013): one curve per channel, or a 3D lattice.
 *
 * <p>Curves are interpolated linearly. Lattices are interpolated tetrahedrally: each cell is cut into six tetrahedra around its
 * gray diagonal (Kasson, Nin, Plouffe and Hafner, Performing color space conversions with three-dimensional linear interpolation,
 * Journal of Electronic Imaging 4(3), 1995), so that grays depend only on grays. Each channel is clamped to the domain.
 */
public final class CubeLut {
    /** Maximum number of entries of a channel's curve. */
    public static final int MAX_ENTRIES = 65536;
    /** Maximum number of points along an edge of a lattice. */
    public static final int MAX_POINTS = 129;

    private final Path file;
    private final boolean is3d;
    private final int size;
    private final float[] colors;
    private final float[] min;
    private final double[] scale;
    private final Optional<CubeLut> shaper;
    private final Optional<Log2Shaper> log;

    /**
     * @param lattice true if {@code colors} is {@code float[3 * size³]}, red first and fastest, then green, then blue; otherwise
     *                {@code float[3 * size]}
     * @param min     lower bound of each channel's domain, below {@code max}
     */
    public CubeLut(Path file, boolean lattice, int size, float[] colors, float[] min, float[] max) {
        this(file, lattice, size, colors, min, max, Optional.empty(), Optional.empty());
    }

    /**
     * @param shaper curves that change a color before this table does; empty for none
     * @param log    logarithm of linear light that the table is made for; empty if the view decides what the table gets
     */
    public CubeLut(Path file, boolean lattice, int size, float[] colors, float[] min, float[] max, Optional<CubeLut> shaper,
            Optional<Log2Shaper> log) {
        this.shaper = shaper;
        this.log = log;
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

    private CubeLut(Path file, CubeLut other) {
        this.file = file;
        is3d = other.is3d;
        size = other.size;
        colors = other.colors;
        min = other.min;
        scale = other.scale;
        shaper = other.shaper;
        log = other.log;
    }

    /** Returns the source file; one that does not exist if the table was made in memory. */
    public Path file() {
        return file;
    }

    /** Returns this table with another file. */
    public CubeLut withFile(Path other) {
        return new CubeLut(other, this);
    }

    /** Returns the logarithm of linear light that the table is made for; empty if the view decides what the table gets. */
    public Optional<Log2Shaper> log() {
        return log;
    }

    /** Returns the size as text, for example {@code 33 × 33 × 33}. */
    public String sizeText() {
        return shaper.map(curves -> curves.sizeText() + ", ").orElse("") + (is3d ? size + " × " + size + " × " + size : "3 × " + size);
    }

    /**
     * Replaces a color by its table value.
     *
     * @param color {@code double[3]}: red, green and blue; NaN counts as the lower bound of the domain
     */
    void apply(double[] color) {
        shaper.ifPresent(curves -> curves.apply(color));
        for (int c = 0; c < 3; c++) {
            double at = (color[c] - min[c]) * scale[c];
            // NaN is not above 0.
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

    /** Interpolates from a corner of the cell along the axes, the largest fraction first, to the opposite corner. */
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
