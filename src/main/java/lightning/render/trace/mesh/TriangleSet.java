package lightning.render.trace.mesh;

/** Some triangles of {@link TriangleBoxes}, those from {@code from} to {@code to} − 1, their box, and the two sets that they are split into. */
final class TriangleSet {
    final int from;
    final int to;
    final float[] box;
    TriangleSet first;
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
