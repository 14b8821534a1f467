package lightning.render.trace.mesh;

import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/** Mesh with its BVH, shared by all shapes that use the mesh. Thread-safe. */
public final class MeshSolid {
    final Mesh mesh;
    final MeshTree tree;
    /** Computed on first use: only anisotropic materials need them. */
    private volatile float @Nullable [] vertexTangents;
    /** Computed on first use: only hits of smooth meshes need them. */
    private volatile float @Nullable [] facetNormals;

    public MeshSolid(Mesh mesh) {
        this.mesh = mesh;
        tree = MeshTree.of(mesh);
    }

    private MeshSolid(Mesh mesh, MeshTree tree) {
        this.mesh = mesh;
        this.tree = tree;
    }

    /** Returns a mesh with an unshared BVH, for measuring the build. */
    public static MeshSolid withUnsharedTree(Mesh mesh) {
        return new MeshSolid(mesh, MeshTreeBuilder.build(mesh));
    }

    /** Returns the bytes of the BVH. */
    public long treeBytes() {
        return tree.bytes();
    }

    public Mesh mesh() {
        return mesh;
    }

    /** Returns x, y and z of each vertex's tangent, of length 1, or 0 for none. The mesh must have texture coordinates. */
    public float[] vertexTangents() {
        float[] known = vertexTangents;
        if (known == null) {
            // Threads that come at the same time compute the same.
            known = VertexTangents.of(mesh, size());
            vertexTangents = known;
        }
        return known;
    }

    /** Returns x, y and z of the mean normal of the facets around each vertex, of about length 1. The mesh must have normals. */
    public float[] facetNormals() {
        float[] known = facetNormals;
        if (known == null) {
            // Threads that come at the same time compute the same.
            known = FacetNormals.of(mesh);
            facetNormals = known;
        }
        return known;
    }

    /** Returns the largest side of the mesh's box. */
    private double size() {
        float[] b = tree.bounds;
        return Math.max((double) b[3] - b[0], Math.max((double) b[4] - b[1], (double) b[5] - b[2]));
    }

    /** Returns one coordinate of the middle of the mesh's box. */
    public double middle(int axis) {
        return 0.5 * ((double) tree.bounds[axis] + tree.bounds[axis + 3]);
    }

    /**
     * Writes a lower bound of the minimum of mx·x + my·y + mz·z + t over the mesh's box to {@code box[i]}, and an upper bound
     * of the maximum to {@code box[i + 3]}.
     */
    public void extent(double mx, double my, double mz, double t, double[] box, int i) {
        float[] b = tree.bounds;
        box[i] = t + Math.min(mx * b[0], mx * b[3]) + Math.min(my * b[1], my * b[4]) + Math.min(mz * b[2], mz * b[5]);
        box[i + 3] = t + Math.max(mx * b[0], mx * b[3]) + Math.max(my * b[1], my * b[4]) + Math.max(mz * b[2], mz * b[5]);
    }

    /**
     * Returns a lower bound on the distance of a point from the mesh, local units: for each triangle the larger of the
     * distances from its box along an axis and from its plane. {@code +∞} without triangles.
     */
    public double surfaceDistance(double x, double y, double z) {
        return surfaceDistance(0, x, y, z, Double.POSITIVE_INFINITY);
    }

    private double surfaceDistance(int node, double x, double y, double z, double limit) {
        double min = limit;
        for (int c = 0; c < MeshTree.WIDTH && tree.child[MeshTree.WIDTH * node + c] != MeshTree.NONE; c++) {
            if (boxDistance(MeshTree.NODE_FLOATS * node + c, x, y, z) < min) {
                int child = tree.child[MeshTree.WIDTH * node + c];
                min = child >= 0 ? surfaceDistance(child, x, y, z, min) : leafDistance(~child, x, y, z, min);
            }
        }
        return min;
    }

    private double boxDistance(int i, double x, double y, double z) {
        float[] b = tree.box;
        return Math.max(Math.max(Math.max(b[i] - x, x - b[i + 8]), Math.max(b[i + 16] - y, y - b[i + 24])),
                Math.max(b[i + 32] - z, z - b[i + 40]));
    }

    private double leafDistance(int leaf, double x, double y, double z, double limit) {
        double min = limit;
        for (int s = 0; s < MeshTree.WIDTH; s++) {
            if (tree.triangle[MeshTree.WIDTH * leaf + s] >= 0) {
                min = Math.min(min, MeshRay.triangleDistance(tree.vertex, tree.corner(leaf, s, 0), tree.corner(leaf, s, 1),
                        tree.corner(leaf, s, 2), MeshTree.AXIS_FLOATS, x, y, z));
            }
        }
        return min;
    }
}
