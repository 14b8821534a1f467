package lightning.render.trace.mesh;

import lightning.scene.Mesh;

/** A mesh and its tree, which all shapes that show the mesh share: what rays meet of a shape that is one. Shared between threads. */
public final class MeshSolid {
    final Mesh mesh;
    final MeshTree tree;

    public MeshSolid(Mesh mesh) {
        this.mesh = mesh;
        tree = MeshTree.of(mesh);
    }

    private MeshSolid(Mesh mesh, MeshTree tree) {
        this.mesh = mesh;
        this.tree = tree;
    }

    /** A mesh with a tree of its own, which nobody shares: for who measures how it is built. */
    public static MeshSolid apart(Mesh mesh) {
        return new MeshSolid(mesh, MeshTreeBuilder.build(mesh));
    }

    /** Bytes of the tree. */
    public long treeBytes() {
        return tree.bytes();
    }

    public Mesh mesh() {
        return mesh;
    }

    /** Writes no more than the least of mx·x + my·y + mz·z + t over the mesh's box to {@code box[i]}, the greatest to {@code box[i + 3]}. */
    public void extent(double mx, double my, double mz, double t, double[] box, int i) {
        float[] b = tree.bounds;
        box[i] = t + Math.min(mx * b[0], mx * b[3]) + Math.min(my * b[1], my * b[4]) + Math.min(mz * b[2], mz * b[5]);
        box[i + 3] = t + Math.max(mx * b[0], mx * b[3]) + Math.max(my * b[1], my * b[4]) + Math.max(mz * b[2], mz * b[5]);
    }

    /**
     * How far a point lies off the mesh at least, own units: off each triangle from its box along an axis or from its plane,
     * whichever is more; {@code +∞} where there is no triangle.
     */
    public double gap(double x, double y, double z) {
        return gap(0, x, y, z, Double.POSITIVE_INFINITY);
    }

    private double gap(int node, double x, double y, double z, double most) {
        double least = most;
        for (int c = 0; c < MeshTree.WIDTH && tree.child[MeshTree.WIDTH * node + c] != MeshTree.NONE; c++) {
            if (boxGap(MeshTree.NODE * node + c, x, y, z) < least) {
                int child = tree.child[MeshTree.WIDTH * node + c];
                least = child >= 0 ? gap(child, x, y, z, least) : leafGap(~child, x, y, z, least);
            }
        }
        return least;
    }

    private double boxGap(int i, double x, double y, double z) {
        float[] b = tree.box;
        return Math.max(Math.max(Math.max(b[i] - x, x - b[i + 8]), Math.max(b[i + 16] - y, y - b[i + 24])),
                Math.max(b[i + 32] - z, z - b[i + 40]));
    }

    private double leafGap(int leaf, double x, double y, double z, double most) {
        double least = most;
        for (int s = 0; s < MeshTree.WIDTH && tree.triangle[MeshTree.WIDTH * leaf + s] >= 0; s++) {
            int at = MeshTree.LEAF * leaf + s;
            least = Math.min(least, MeshRay.gap(tree.vertex, at, at + MeshTree.VERTEX, at + 2 * MeshTree.VERTEX, MeshTree.WIDTH, x, y, z));
        }
        return least;
    }
}
