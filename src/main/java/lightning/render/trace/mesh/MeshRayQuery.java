package lightning.render.trace.mesh;

import java.util.function.Supplier;
import lightning.base.Initializer;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Queries for the triangle that a single ray hits, in the space of the mesh. Holds scratch memory: use one per thread.
 * <pre>{@code
 * query.setRay(solid, ox, oy, oz, dx, dy, dz);
 * double t = query.nearest(Double.POSITIVE_INFINITY);
 * int triangle = query.triangle();
 * }</pre>
 */
public final class MeshRayQuery {
    private final MeshRay ray = new MeshRay();
    private final MeshTraversal traversal;
    private MeshSolid solid;
    private int triangle;
    /** Null if the mesh has no cutouts. */
    private @Nullable AlphaTest alphaTest;

    /** Creates a query with the tests that the process uses at each time. */
    public MeshRayQuery() {
        this(null);
    }

    /** @param fixedTests tests to use; null for those of the process at each time */
    MeshRayQuery(@Nullable Supplier<MeshTests> fixedTests) {
        traversal = new MeshTraversal(fixedTests);
    }

    /** Sets a mesh and a ray; the direction has any length. */
    @Initializer
    public void setRay(MeshSolid newSolid, double ox, double oy, double oz, double dx, double dy, double dz) {
        solid = newSolid;
        ray.setRay(ox, oy, oz, dx, dy, dz, newSolid.tree.maxCoordinate);
        alphaTest = null;
    }

    /**
     * Makes the ray ignore all triangles within a distance of a point, local units: the ray starts or ends on them, up to
     * rounding.
     */
    public void ignoreNear(double x, double y, double z, double distance) {
        ray.ignoreNear(x, y, z, distance);
    }

    /** Sets the alpha test that lets the ray pass through holes of triangles. */
    public void setAlphaTest(AlphaTest test) {
        alphaTest = test;
    }

    /**
     * Returns the distance to the first triangle hit, the lowest among equal distances; {@code +∞} if there is none up to
     * {@code limit}.
     */
    public double nearest(double limit) {
        double t = traversal.nearest(solid.tree, ray, alphaTest, limit);
        triangle = traversal.triangle;
        return t;
    }

    /** Returns the distance to the first triangle hit; tests every triangle. */
    public double nearestBruteForce() {
        Mesh mesh = solid.mesh;
        int[] v = mesh.triangles();
        double best = MeshRay.MISS;
        triangle = -1;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            double t = ray.distance(mesh.positions(), 3 * v[3 * i], 3 * v[3 * i + 1], 3 * v[3 * i + 2], 1);
            if (t < best && (alphaTest == null || !alphaTest.isHole(i, t))) {
                best = t;
                triangle = i;
            }
        }
        return best;
    }

    /** Finds all triangles that the ray hits at distances below {@code limit}, in any order. */
    public void collectHits(double limit) {
        traversal.collectHits(solid.tree, ray, limit);
    }

    /**
     * Finds the triangles that a ray hits before its end at distance 1, in any order.
     *
     * @param buffer light buffer of the mesh and the end
     */
    public void collectHits(LightBuffer buffer, MeshSolid newSolid, double ox, double oy, double oz, double dx, double dy, double dz) {
        int place = buffer.place(ox, oy, oz, dx, dy, dz);
        if (place == LightBuffer.NO_CELL || place >= 0 && traversal.findLeaves(buffer, place) == 0) {
            traversal.clearHits();
            return;
        }
        setRay(newSolid, ox, oy, oz, dx, dy, dz);
        if (place >= 0) {
            traversal.collectHits(solid.tree, ray);
        } else {
            traversal.collectHits(solid.tree, ray, 1);
        }
    }

    /** Finds the same triangles; tests every triangle. */
    public void collectHitsBruteForce(double limit) {
        Mesh mesh = solid.mesh;
        int[] v = mesh.triangles();
        traversal.clearHits();
        for (int i = 0; i < mesh.triangleCount(); i++) {
            double t = ray.distance(mesh.positions(), 3 * v[3 * i], 3 * v[3 * i + 1], 3 * v[3 * i + 2], 1);
            if (t < limit) {
                traversal.addHit(i, t);
            }
        }
    }

    /** Returns the number of hits found. */
    public int hitCount() {
        return traversal.hitCount;
    }

    public int hitTriangle(int i) {
        return traversal.hitTriangle[i];
    }

    public double hitDistance(int i) {
        return traversal.hitDistance[i];
    }

    /** Returns the triangle found last, −1 for none. */
    public int triangle() {
        return triangle;
    }

    /** Returns whether the ray hits a triangle at a distance below {@code limit}. */
    public boolean isBlocked(double limit) {
        return traversal.isBlocked(solid.tree, ray, alphaTest, limit);
    }
}
