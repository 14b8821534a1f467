package lightning.render.trace.mesh;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Leaves of a mesh's BVH by direction from one point, for shadow rays that end there (Haines and Greenberg 1986, The Light Buffer).
 * A ray finds its leaves in one cell of a grid instead of descending from the root. Immutable.
 *
 * <p>The grid covers the mesh as seen from the point, in a plane perpendicular to an axis: a place at depth h along the axis has the
 * image coordinates (across / h). Each cell lists the leaves whose boxes it may show.
 *
 * <p><b>No leaf is lost.</b> A ray that {@link MeshRay} lets hit a triangle passes within twice its padding of the triangle's box
 * (docs/numerics.md, "Proof: boxes of mesh triangles"). {@link #cell} accepts only rays whose padding and whose distance of their end from
 * the point are at most 2⁻³⁶ of the smallest depth. So the images of ray and box are less than 2⁻³³·(1 + U) apart, where U is the
 * largest image coordinate, and boxes are enlarged by 2⁻³⁰·(1 + U).
 */
public final class LightBuffer {
    /** The ray hits no triangle. */
    static final int NO_CELL = -1;
    /** The ray does not end at the point, up to rounding. */
    static final int OTHER_END = -2;
    /** Maximum number of child references: cells store them as {@code char}. */
    private static final int MAX_REFERENCES = 1 << 16;
    /** Maximum cells along a side. */
    private static final int MAX_SIDE = 128;
    /** Maximum mean number of cells that list a leaf. */
    private static final int MAX_CELLS_PER_LEAF = 24;
    /** Minimum depth relative to the longest side of the mesh's box. */
    private static final double MIN_DEPTH_SHARE = 0x1p-4;
    private static final double TOLERANCE_SHARE = 0x1p-36;
    private static final double MARGIN_SHARE = 0x1p-30;

    private final double x;
    private final double y;
    private final double z;
    /** Axis of the depth, 0 1 2, and its direction, 1 or −1. */
    private final int axis;
    private final double sign;
    private final double minDepth;
    private final double tolerance;
    /** Largest absolute coordinate of a ray's origin. */
    private final double maxOrigin;
    private double minU = Double.POSITIVE_INFINITY;
    private double minV = Double.POSITIVE_INFINITY;
    private double maxU = Double.NEGATIVE_INFINITY;
    private double maxV = Double.NEGATIVE_INFINITY;
    private double scaleU;
    private double scaleV;
    private int side;
    /** The cell {@code i} lists the children {@code references[start[i] … start[i + 1] − 1]} of nodes. */
    private int[] start = {};
    private char[] references = {};

    private LightBuffer(MeshTree tree, double x, double y, double z, int axis, double sign, double minDepth) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.axis = axis;
        this.sign = sign;
        this.minDepth = minDepth;
        tolerance = TOLERANCE_SHARE * minDepth;
        maxOrigin = tolerance / MeshRay.PADDING_SHARE - tree.maxCoordinate;
        build(tree);
    }

    /** Returns the buffer of a point in the mesh's space; null if the point is too near to the mesh or the mesh is too large. */
    public static @Nullable LightBuffer of(MeshSolid solid, double x, double y, double z) {
        MeshTree tree = solid.tree;
        float[] b = tree.bounds;
        double extent = Math.max(b[3] - b[0], Math.max(b[4] - b[1], b[5] - b[2]));
        int axis = -1;
        double sign = 1;
        double minDepth = Math.max(extent * MIN_DEPTH_SHARE, Double.MIN_NORMAL);
        for (int k = 0; k < 3; k++) {
            double p = k == 0 ? x : k == 1 ? y : z;
            double depth = Math.max(b[k] - p, p - b[k + 3]);
            if (depth >= minDepth) {
                minDepth = depth;
                axis = k;
                sign = b[k] - p > 0 ? 1 : -1;
            }
        }
        return axis < 0 || minDepth == Double.POSITIVE_INFINITY || tree.child.length > MAX_REFERENCES ? null
                : new LightBuffer(tree, x, y, z, axis, sign, minDepth);
    }

    /** Returns the approximate bytes. */
    public long bytes() {
        return 4L * start.length + 2L * references.length;
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
        addMargin(image);
        side = Math.min(MAX_SIDE, (int) Math.sqrt(leaves) + 1);
        while (countReferences(image) > (long) MAX_CELLS_PER_LEAF * leaves) {
            side = (side + 1) / 2;
        }
        fill(image, leafReference);
    }

    /** Writes the image of a box: minimum and maximum along both image axes. */
    private void project(float[] box, int i, double[] image, int at) {
        double near = sign > 0 ? box[i + 16 * axis] - along(axis) : along(axis) - box[i + 16 * axis + 8];
        double far = sign > 0 ? box[i + 16 * axis + 8] - along(axis) : along(axis) - box[i + 16 * axis];
        int a = axis == 0 ? 1 : 0;
        for (int k = 0; k < 2; k++) {
            double low = box[i + 16 * a] - along(a);
            double high = box[i + 16 * a + 8] - along(a);
            image[at + 2 * k] = low / (low < 0 ? near : far);
            image[at + 2 * k + 1] = high / (high < 0 ? far : near);
            a = axis == 2 ? 1 : 2;
        }
    }

    private double along(int a) {
        return a == 0 ? x : a == 1 ? y : z;
    }

    /** Enlarges all images by the margin, and sets the bounds of the grid. */
    private void addMargin(double[] image) {
        double max = 0;
        for (double c : image) {
            max = Math.max(max, Math.abs(c));
        }
        double margin = MARGIN_SHARE * (1 + max);
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
        scaleU = side / (maxU - minU);
        scaleV = side / (maxV - minV);
        start = new int[side * side + 1];
        long sum = 0;
        for (int i = 0; i < image.length; i += 4) {
            int fromU = column(image[i]);
            int toU = column(image[i + 1]);
            int toV = line(image[i + 3]);
            for (int v = line(image[i + 2]); v <= toV; v++) {
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
        references = new char[start[side * side]];
        int[] next = Arrays.copyOf(start, side * side);
        for (int i = 0; i < image.length; i += 4) {
            int fromU = column(image[i]);
            int toU = column(image[i + 1]);
            int toV = line(image[i + 3]);
            for (int v = line(image[i + 2]); v <= toV; v++) {
                for (int u = fromU; u <= toU; u++) {
                    references[next[v * side + u]++] = (char) leafReference[i / 4];
                }
            }
        }
    }

    private int column(double u) {
        return Math.min((int) ((u - minU) * scaleU), side - 1);
    }

    private int line(double v) {
        return Math.min((int) ((v - minV) * scaleV), side - 1);
    }

    /** Returns the cell of a ray that should end at the point at distance 1, {@link #NO_CELL} or {@link #OTHER_END}. */
    int cell(double ox, double oy, double oz, double dx, double dy, double dz) {
        if (!(Math.abs(ox + dx - x) <= tolerance && Math.abs(oy + dy - y) <= tolerance && Math.abs(oz + dz - z) <= tolerance
                && Math.abs(ox) <= maxOrigin && Math.abs(oy) <= maxOrigin && Math.abs(oz) <= maxOrigin)) {
            return OTHER_END;
        }
        double along = axis == 0 ? dx : axis == 1 ? dy : dz;
        double u = (axis == 0 ? dy : dx) / along;
        double v = (axis == 2 ? dy : dz) / along;
        // The origin is in front of the mesh, seen from the point.
        boolean isShort = -sign * along < minDepth * 0.5;
        // Image coordinates are across / depth, with depth = sign · along.
        u *= sign;
        v *= sign;
        return isShort || !(u >= minU && u <= maxU && v >= minV && v <= maxV) ? NO_CELL : line(v) * side + column(u);
    }

    /** Returns the index of the cell's first reference; that of the next cell is its end. */
    int start(int cell) {
        return start[cell];
    }

    /** Returns child {@code r % 8} of node {@code r / 8}, a leaf, of the reference with an index. */
    int reference(int i) {
        return references[i];
    }
}
