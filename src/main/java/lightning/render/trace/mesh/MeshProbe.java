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
public final class MeshProbe {
    private final MeshRay ray = new MeshRay();
    private final MeshWalk walk = new MeshWalk();
    private MeshSolid solid;
    private int triangle;
    /** Null where the mesh has no holes. */
    private Sieve sieve;

    /** Takes a mesh and a ray; the direction has any length. */
    public void enter(MeshSolid of, double ox, double oy, double oz, double dx, double dy, double dz) {
        solid = of;
        ray.enter(ox, oy, oz, dx, dy, dz, of.tree.reach);
        sieve = null;
    }

    /** Lets the ray pass all triangles that are this near to a point, own units: it begins or ends on them, as far as rounding can tell. */
    public void pass(double x, double y, double z, double near) {
        ray.pass(x, y, z, near);
    }

    /** Lets the ray pass triangles where they have holes. */
    public void sift(Sieve by) {
        sieve = by;
    }

    /** The distance to the triangle that is met first, the lowest among equals; {@code +∞} where none is up to {@code limit}. */
    public double nearest(double limit) {
        double t = walk.nearest(solid.tree, ray, sieve, limit);
        triangle = walk.triangle;
        return t;
    }

    /** The same by asking every triangle in turn. */
    public double nearestOfAll() {
        Mesh mesh = solid.mesh;
        int[] v = mesh.triangles();
        double best = MeshRay.MISS;
        triangle = -1;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            double t = ray.distance(mesh.positions(), 3 * v[3 * i], 3 * v[3 * i + 1], 3 * v[3 * i + 2], 1);
            if (t < best && (sieve == null || !sieve.passes(i, t))) {
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
    public boolean blocked(double limit) {
        return walk.blocked(solid.tree, ray, sieve, limit);
    }
}
