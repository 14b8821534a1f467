package lightning.render.trace.mesh;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Leaves of a mesh's BVH by direction from a few neighboring points, for shadow rays that end there (after Haines and Greenberg 1986, The
 * Light Buffer). A ray finds its leaves in one cell of a grid instead of descending from the root. Immutable.
 *
 * <p>The grid lies in a plane through the middle of the mesh, perpendicular to an axis. Each cell lists the leaves whose boxes a line
 * from any point may show there, each with a bit for those of its 4 × 4 parts that may show the box.
 *
 * <p><b>No leaf is lost.</b> A ray that {@link MeshRay} lets hit a triangle passes within twice its padding of the triangle's box
 * (docs/numerics.md, "Proof: boxes of mesh triangles"). {@link #place} accepts only rays whose padding and whose distance of their end from
 * the points' box are at most 2⁻³⁶·D, where D is the smallest depth. The image of X, seen from E, is E + r·(X − E) with r = 1 + (depth of
 * the plane − that of X)/(depth of X), and |r| ≤ 17, because the mesh is at most 16 D long. So the images of ray and box are less than
 * 2⁻²⁸·M apart, where M bounds D and all coordinates, and so is the error of computing them. Boxes are enlarged by 2⁻²⁴·M.
 */
public final class LightBuffer {
    /** The ray hits no triangle. */
    static final int NO_CELL = -1;
    /** The ray does not end at the points, up to rounding. */
    static final int OTHER_END = -2;
    /** Bits of an entry below the parts of its cell: a child reference. */
    static final int REFERENCE_BITS = 16;
    /** Bits of {@link #place} below the cell: one of its parts. */
    static final int PART_BITS = 4;
    /** Maximum number of child references. */
    private static final int MAX_REFERENCES = 1 << REFERENCE_BITS;
    /** Parts along a side of a cell. */
    private static final int PARTS = 4;
    /** Maximum cells along a side. */
    private static final int MAX_SIDE = 128;
    /** Maximum mean number of cells that list a leaf. */
    private static final int MAX_CELLS_PER_LEAF = 24;
    /** Minimum depth relative to the longest side of the mesh's box. */
    private static final double MIN_DEPTH_SHARE = 0x1p-4;
    private static final double TOLERANCE_SHARE = 0x1p-36;
    private static final double MARGIN_SHARE = 0x1p-24;

    /** Bounds of the points: min x y z, max x y z. */
    private final double[] points;
    /** Axis of the depth, 0 1 2, and its direction from the points to the mesh, 1 or −1. */
    private final int axis;
    private final double sign;
    private final double minDepth;
    private final double tolerance;
    /** Largest absolute coordinate of a ray's origin. */
    private final double maxOrigin;
    /** Coordinate of the grid along the axis. */
    private final double plane;
    private double minU = Double.POSITIVE_INFINITY;
    private double minV = Double.POSITIVE_INFINITY;
    private double maxU = Double.NEGATIVE_INFINITY;
    private double maxV = Double.NEGATIVE_INFINITY;
    private double scaleU;
    private double scaleV;
    private int side;
    /**
     * The entries {@code start[i] … start[i + 1] − 1} belong to cell {@code i}. The lower half of an entry is child {@code r % 8} of node
     * {@code r / 8}, a leaf. The upper half has a bit for each part of the cell that may show the leaf.
     */
    int[] start = {};
    int[] entries = {};

    private LightBuffer(MeshTree tree, double[] points, int axis, double sign, double minDepth) {
        this.points = points;
        this.axis = axis;
        this.sign = sign;
        this.minDepth = minDepth;
        tolerance = TOLERANCE_SHARE * minDepth;
        maxOrigin = tolerance / MeshRay.PADDING_SHARE - tree.maxCoordinate;
        plane = 0.5 * ((double) tree.bounds[axis] + tree.bounds[axis + 3]);
        build(tree);
    }

    /**
     * Returns the buffer of neighboring points; null if one of them is too near to the mesh or the mesh is too large.
     *
     * @param points bounds of the points in the mesh's space: min x y z, max x y z
     */
    public static @Nullable LightBuffer of(MeshSolid solid, double[] points) {
        MeshTree tree = solid.tree;
        float[] b = tree.bounds;
        double extent = Math.max(b[3] - b[0], Math.max(b[4] - b[1], b[5] - b[2]));
        int axis = -1;
        double sign = 1;
        double minDepth = Math.max(extent * MIN_DEPTH_SHARE, Double.MIN_NORMAL);
        for (int k = 0; k < 3; k++) {
            double depth = Math.max(b[k] - points[k + 3], points[k] - b[k + 3]);
            if (depth >= minDepth) {
                minDepth = depth;
                axis = k;
                sign = b[k] > points[k] ? 1 : -1;
            }
        }
        return axis < 0 || minDepth == Double.POSITIVE_INFINITY || tree.child.length > MAX_REFERENCES ? null
                : new LightBuffer(tree, points, axis, sign, minDepth);
    }

    /** Returns the approximate bytes. */
    public long bytes() {
        return 4L * (start.length + entries.length);
    }

    /** Returns the number of leaves of a mesh: the build takes about as long as so many shadow rays. */
    public static int leafCount(MeshSolid solid) {
        return solid.tree.triangle.length / MeshTree.WIDTH;
    }

    private void build(MeshTree tree) {
        int leaves = tree.triangle.length / MeshTree.WIDTH;
        int[] leafReference = new int[leaves];
        double[] image = new double[4 * leaves];
        for (int i = 0; i < tree.child.length; i++) {
            int leaf = ~tree.child[i];
            if (leaf >= 0 && tree.child[i] != MeshTree.NONE) {
                leafReference[leaf] = i;
                project(tree.box, MeshTree.NODE_FLOATS * (i / MeshTree.WIDTH) + i % MeshTree.WIDTH, image, 4 * leaf);
            }
        }
        addMargin(tree, image);
        side = Math.min(MAX_SIDE, (int) Math.sqrt(leaves) + 1);
        while (countReferences(image) > (long) MAX_CELLS_PER_LEAF * leaves) {
            side = (side + 1) / 2;
        }
        fill(image, leafReference);
    }

    /** Writes the image of a box, seen from all points: minimum and maximum along both image axes. */
    private void project(float[] box, int i, double[] image, int at) {
        double minScale = Double.POSITIVE_INFINITY;
        double maxScale = 0;
        for (int corner = 0; corner < 4; corner++) {
            double from = points[axis + 3 * (corner & 1)];
            double scale = (plane - from) / (box[i + 16 * axis + 4 * (corner & 2)] - from);
            minScale = Math.min(minScale, scale);
            maxScale = Math.max(maxScale, scale);
        }
        for (int k = 0; k < 2; k++) {
            int a = k == 0 ? acrossU() : acrossV();
            double low = box[i + 16 * a];
            double high = box[i + 16 * a + 8];
            image[at + 2 * k] = Math.min(minImage(low, a, minScale), minImage(low, a, maxScale));
            image[at + 2 * k + 1] = Math.max(maxImage(high, a, minScale), maxImage(high, a, maxScale));
        }
    }

    private double minImage(double low, int a, double scale) {
        return low * scale + points[scale < 1 ? a : a + 3] * (1 - scale);
    }

    private double maxImage(double high, int a, double scale) {
        return high * scale + points[scale < 1 ? a + 3 : a] * (1 - scale);
    }

    private int acrossU() {
        return axis == 0 ? 1 : 0;
    }

    private int acrossV() {
        return axis == 2 ? 1 : 2;
    }

    /** Enlarges all images by the margin, and sets the bounds of the grid. */
    private void addMargin(MeshTree tree, double[] image) {
        double max = Math.max(minDepth, tree.maxCoordinate);
        for (double c : points) {
            max = Math.max(max, Math.abs(c));
        }
        for (double c : image) {
            max = Math.max(max, Math.abs(c));
        }
        double margin = MARGIN_SHARE * max;
        for (int i = 0; i < image.length; i += 4) {
            image[i] -= margin;
            image[i + 1] += margin;
            image[i + 2] -= margin;
            image[i + 3] += margin;
            minU = Math.min(minU, image[i]);
            maxU = Math.max(maxU, image[i + 1]);
            minV = Math.min(minV, image[i + 2]);
            maxV = Math.max(maxV, image[i + 3]);
        }
    }

    /** Counts the references of all cells into {@link #start} of the next cell; returns their sum. */
    private long countReferences(double[] image) {
        scaleU = PARTS * side / (maxU - minU);
        scaleV = PARTS * side / (maxV - minV);
        start = new int[side * side + 1];
        long sum = 0;
        for (int i = 0; i < image.length; i += 4) {
            int fromU = column(image[i]) / PARTS;
            int toU = column(image[i + 1]) / PARTS;
            int toV = line(image[i + 3]) / PARTS;
            for (int v = line(image[i + 2]) / PARTS; v <= toV; v++) {
                for (int u = fromU; u <= toU; u++) {
                    start[v * side + u + 1]++;
                }
                sum += toU - fromU + 1;
            }
        }
        return sum;
    }

    private void fill(double[] image, int[] leafReference) {
        for (int i = 0; i < side * side; i++) {
            start[i + 1] += start[i];
        }
        entries = new int[start[side * side]];
        int[] next = Arrays.copyOf(start, side * side);
        for (int i = 0; i < image.length; i += 4) {
            int fromU = column(image[i]);
            int toU = column(image[i + 1]);
            int fromV = line(image[i + 2]);
            int toV = line(image[i + 3]);
            for (int v = fromV / PARTS; v <= toV / PARTS; v++) {
                int lines = parts(v, fromV, toV);
                // The bits of the lines, four apart.
                int spread = lines & 1 | (lines & 2) << 3 | (lines & 4) << 6 | (lines & 8) << 9;
                for (int u = fromU / PARTS; u <= toU / PARTS; u++) {
                    int shown = parts(u, fromU, toU) * spread;
                    entries[next[v * side + u]++] = shown << REFERENCE_BITS | leafReference[i / 4];
                }
            }
        }
    }

    /** Returns the parts along a side of a cell that are in a range of parts of the grid, one bit each. */
    private static int parts(int cell, int from, int to) {
        int first = Math.max(0, from - PARTS * cell);
        int last = Math.min(PARTS - 1, to - PARTS * cell);
        return (2 << last) - (1 << first);
    }

    private int column(double u) {
        return Math.min((int) ((u - minU) * scaleU), PARTS * side - 1);
    }

    private int line(double v) {
        return Math.min((int) ((v - minV) * scaleV), PARTS * side - 1);
    }

    /**
     * Returns the place of a ray that should end at the points at distance 1: its cell, times 16, plus the part of the cell, line by line.
     * Returns {@link #NO_CELL} or {@link #OTHER_END} if it has none.
     */
    int place(double ox, double oy, double oz, double dx, double dy, double dz) {
        if (!(isAtPoints(ox + dx, 0) && isAtPoints(oy + dy, 1) && isAtPoints(oz + dz, 2) && Math.abs(ox) <= maxOrigin
                && Math.abs(oy) <= maxOrigin && Math.abs(oz) <= maxOrigin)) {
            return OTHER_END;
        }
        double along = axis == 0 ? dx : axis == 1 ? dy : dz;
        double t = (plane - (axis == 0 ? ox : axis == 1 ? oy : oz)) / along;
        double u = axis == 0 ? oy + t * dy : ox + t * dx;
        double v = axis == 2 ? oy + t * dy : oz + t * dz;
        // The origin is in front of the mesh, seen from the points.
        boolean isShort = -sign * along < minDepth * 0.5;
        if (isShort || !(u >= minU && u <= maxU && v >= minV && v <= maxV)) {
            return NO_CELL;
        }
        int column = column(u);
        int line = line(v);
        return line / PARTS * side + column / PARTS << PART_BITS | line % PARTS * PARTS | column % PARTS;
    }

    private boolean isAtPoints(double end, int a) {
        return end >= points[a] - tolerance && end <= points[a + 3] + tolerance;
    }
}
