package lightning.render.trace.mesh;

import lightning.scene.Mesh;

/**
 * Asks meshes what a ray meets, one ray after the other; all in the space of the mesh. Scratch memory: one for each thread.
 *
 * <pre>{@code
 * probe.enter(solid, ox, oy, oz, dx, dy, dz);
 * double t = probe.nearest(Double.POSITIVE_INFINITY);
 * int triangle = probe.triangle();
 * }</pre>
 */
public final class MeshRayQuery {
    private final MeshRay ray = new MeshRay();
    private final MeshTraversal traversal = new MeshTraversal();
    private MeshSolid solid;
    private int triangle;
    /** Null where the mesh has no holes. */
    private AlphaTest alphaTest;

    /** Takes a mesh and a ray; the direction has any length. */
    public void setRay(MeshSolid newSolid, double ox, double oy, double oz, double dx, double dy, double dz) {
        solid = newSolid;
        ray.setRay(ox, oy, oz, dx, dy, dz, newSolid.tree.maxCoordinate);
        alphaTest = null;
    }

    /** Lets the ray pass all triangles that are this near to a point, own units: it begins or ends on them, as far as rounding can tell. */
    public void ignoreNear(double x, double y, double z, double distance) {
        ray.ignoreNear(x, y, z, distance);
    }

    /** Lets the ray pass triangles where they have holes. */
    public void setAlphaTest(AlphaTest test) {
        alphaTest = test;
    }

    /** The distance to the triangle that is met first, the lowest among equals; {@code +∞} where none is up to {@code limit}. */
    public double nearest(double limit) {
        double t = traversal.nearest(solid.tree, ray, alphaTest, limit);
        triangle = traversal.triangle;
        return t;
    }

    /** The same by asking every triangle in turn. */
    public double nearestBruteForce() {
        Mesh mesh = solid.mesh;
        int[] v = mesh.triangles();
        double best = MeshRay.MISS;
        triangle = -1;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            double t = ray.distance(mesh.positions(), 3 * v[3 * i], 3 * v[3 * i + 1], 3 * v[3 * i + 2], 1);
            if (t < best && (alphaTest == null || !alphaTest.passes(i, t))) {
                best = t;
                triangle = i;
            }
        }
        return best;
    }

    /** The triangle that was found last, −1 where none was. */
    public int triangle() {
        return triangle;
    }

    /** Whether a triangle is met at a distance below {@code limit}. */
    public boolean isBlocked(double limit) {
        return traversal.isBlocked(solid.tree, ray, alphaTest, limit);
    }
}
