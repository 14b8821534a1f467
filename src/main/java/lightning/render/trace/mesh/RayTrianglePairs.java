package lightning.render.trace.mesh;

import java.util.Arrays;

/**
 * Pairs of rays and triangles that may hit, tested eight at a time whatever their rays and leaves, and the hits among them. Reused; not
 * thread-safe.
 */
final class RayTrianglePairs {
    private static final int ALL = -1 >>> -LeafTriangleLanes.RAYS;

    private final MeshRayLanes rays;
    /** Limit of each ray. */
    private final double[] limit;
    /** Copies of the rays and the triangles of the pairs that are not tested yet. */
    private final MeshRayLanes pairRays = new MeshRayLanes(LeafTriangleLanes.RAYS);
    private final LeafTriangleLanes pairs = new LeafTriangleLanes(pairRays, LeafTriangleLanes.RAYS);
    private final int[] pairRay = new int[LeafTriangleLanes.RAYS];
    private final int[] pairTriangle = new int[LeafTriangleLanes.RAYS];
    private int pairCount;
    /** Hits of the tested pairs. */
    int hitCount;
    int[] hitRay = new int[1024];
    int[] hitTriangle = new int[1024];
    double[] hitDistance = new double[1024];

    RayTrianglePairs(MeshRayLanes rays, double[] limit) {
        this.rays = rays;
        this.limit = limit;
    }

    /** Removes all hits. */
    void clear() {
        hitCount = 0;
    }

    /** Adds the pairs of a ray and the triangles of a leaf in some slots, one bit each. */
    void add(MeshTree tree, int ray, int leaf, int slots) {
        for (int left = slots; left != 0; left &= left - 1) {
            int s = Integer.numberOfTrailingZeros(left);
            int n = pairCount++;
            pairRay[n] = ray;
            pairTriangle[n] = MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + s]);
            pairRays.ox[n] = rays.ox[ray];
            pairRays.oy[n] = rays.oy[ray];
            pairRays.oz[n] = rays.oz[ray];
            pairRays.dx[n] = rays.dx[ray];
            pairRays.dy[n] = rays.dy[ray];
            pairRays.dz[n] = rays.dz[ray];
            pairRays.padding[n] = rays.padding[ray];
            copyVertices(tree, MeshTree.LEAF_FLOATS * leaf + s, Math.min(2, MeshTree.lastCorner(tree.triangle[MeshTree.WIDTH * leaf + s])),
                    n);
            if (pairCount == LeafTriangleLanes.RAYS) {
                test();
            }
        }
    }

    /** Copies the vertices of a triangle, the last one last; the order of the others does not change the distance. */
    private void copyVertices(MeshTree tree, int first, int last, int n) {
        copyVertex(tree.vertex, first + (last == 0 ? MeshTree.CORNER_FLOATS : 0), n);
        copyVertex(tree.vertex, first + (last == 2 ? MeshTree.CORNER_FLOATS : 2 * MeshTree.CORNER_FLOATS), 3 * MeshTree.WIDTH + n);
        copyVertex(tree.vertex, first + MeshTree.CORNER_FLOATS * last, 6 * MeshTree.WIDTH + n);
    }

    private void copyVertex(float[] v, int from, int to) {
        pairs.vertex[to] = v[from];
        pairs.vertex[MeshTree.WIDTH + to] = v[from + MeshTree.AXIS_FLOATS];
        pairs.vertex[2 * MeshTree.WIDTH + to] = v[from + 2 * MeshTree.AXIS_FLOATS];
    }

    /** Tests the pairs that are not tested yet. */
    void test() {
        pairs.computeDistances(0, ALL & ~(-1 << pairCount));
        for (int n = 0; n < pairCount; n++) {
            double t = pairs.distance[n];
            if (t < limit[pairRay[n]]) {
                addHit(pairRay[n], pairTriangle[n], t);
            }
        }
        pairCount = 0;
    }

    private void addHit(int ray, int id, double t) {
        if (hitCount == hitRay.length) {
            hitRay = Arrays.copyOf(hitRay, 2 * hitCount);
            hitTriangle = Arrays.copyOf(hitTriangle, 2 * hitCount);
            hitDistance = Arrays.copyOf(hitDistance, 2 * hitCount);
        }
        hitRay[hitCount] = ray;
        hitTriangle[hitCount] = id;
        hitDistance[hitCount++] = t;
    }
}
