package lightning.render.trace.mesh;

import org.jspecify.annotations.Nullable;

/**
 * Set of triangles in {@link TriangleBoxes}, from {@code from} to {@code to} − 1, with its bounds and the two sets that it is
 * split into.
 */
final class TriangleSet {
    final int from;
    final int to;
    final float[] box;
    @Nullable
    TriangleSet first;
    @Nullable
    TriangleSet second;

    TriangleSet(int from, int to, float[] box) {
        this.from = from;
        this.to = to;
        this.box = box;
    }

    boolean isLeaf() {
        return first == null;
    }
}
