package lightning.render.trace.mesh;

import lightning.base.Initializer;
import lightning.render.trace.solid.LaneRays;

/**
 * Filter of the rays that may hit triangles of a leaf, and of those triangles, for rays traced together. Holds scratch memory:
 * use one per thread.
 */
final class LeafRayFilter {
    /** Minimum number of rays with a common origin for which the work per leaf pays off. */
    private static final int MIN_COMMON_ORIGIN_RAYS = 2;
    /** Minimum number of rays with a common origin that are tested in lanes. */
    private static final int MIN_LANE_RAYS = 6;
    /** Number of triangles in a beam from which on testing rays against the boxes of leaves first pays off. */
    private static final int MANY_TRIANGLES = 5;
    /** Maximum number of rays in the box of such a leaf that are tested one by one. */
    private static final int MAX_SINGLE_RAYS = 24;

    private final MeshFloatLines lines;
    private final CommonOriginCulling commonOriginCulling = new CommonOriginCulling();
    /** Rays of each packet that enter the leaf. */
    private final int[] enteringRays;
    /** Slots of the triangles that each ray may hit, and the first of these. */
    final int[] slots;
    private final int[] firstSlot;
    /** Rays that may hit more than one triangle. */
    long multipleRays;
    private MeshTree tree;
    private int leaf;
    /** True if the latest beam that was tested in lanes had many triangles in its leaf. */
    private boolean hasManyTriangles;
    /** Longest side of the leaf's box. */
    private float extent;
    /** Target of the prefetch loads, so that they are not eliminated. */
    float prefetchSink;

    /**
     * @param firstSlot receives the first slot of each ray
     * @param capacity number of rays, whole packets
     */
    LeafRayFilter(MeshFloatLines lines, int[] firstSlot, int capacity) {
        this.lines = lines;
        this.firstSlot = firstSlot;
        enteringRays = new int[capacity / LaneRays.WIDTH];
        slots = new int[capacity];
    }

    /** Returns the longest side of the box {@code b[i]}. */
    static float extent(float[] b, int i) {
        return Math.max(b[i + 8] - b[i], Math.max(b[i + 24] - b[i + 16], b[i + 40] - b[i + 32]));
    }

    /**
     * Filters the rays {@code from … end − 1}, whole packets, by a leaf whose box is {@code newTree.box[box]}. Returns the rays that
     * may hit triangles, one bit each; writes {@link #slots}.
     *
     * @param rayMask rays to test, one bit each
     * @param beam beam of these rays, which enters the leaf at a distance with the bits {@code entryBits}
     */
    @Initializer
    long findCandidates(MeshTree newTree, int at, int box, long rayMask, int from, int end, MeshBeam beam, int entryBits) {
        tree = newTree;
        leaf = at;
        float[] v = newTree.vertex;
        int first = MeshTree.LEAF_FLOATS * at;
        // Prefetches the cache lines of the leaf before testing boxes: a fifth less time for shadow rays.
        prefetchSink = v[first] + v[first + 16] + v[first + 32] + v[first + MeshTree.LEAF_FLOATS - 1];
        extent = extent(newTree.box, box);
        boolean inLanes = lines.hasSharedStart && Long.bitCount(rayMask) >= MIN_LANE_RAYS;
        if (inLanes && !hasManyTriangles) {
            return testInLanes(rayMask, from, end, beam, entryBits);
        }
        lines.prepareBoxTests();
        int count = 0;
        for (int i = from; i < end; i += LaneRays.WIDTH) {
            int requested = (int) (rayMask >>> i) & -1 >>> -LaneRays.WIDTH;
            int entering = requested == 0 ? 0 : lines.enteringRays(newTree.box, box, i) & requested;
            enteringRays[i / LaneRays.WIDTH] = entering;
            count += Integer.bitCount(entering);
        }
        if (inLanes && count > MAX_SINGLE_RAYS) {
            return testInLanes(rayMask, from, end, beam, entryBits);
        }
        // Runs all tests first and evaluates them afterwards: one branch misprediction instead of one for every other ray.
        return lines.hasSharedStart && count >= MIN_COMMON_ORIGIN_RAYS ? testWithCommonOrigin(from, end) : testSeparately(from, end);
    }

    /** Tests rays with a common origin in lanes against the triangles that their beam may hit. */
    private long testInLanes(long rayMask, int from, int end, MeshBeam beam, int entryBits) {
        commonOriginCulling.setLeaf(tree.vertex, MeshTree.LEAF_FLOATS * leaf, lines.sharedX, lines.sharedY, lines.sharedZ,
                CommonOriginCulling.minVolume(lines.sharedWidth, extent));
        float margin = CommonOriginCulling.margin(lines.sharedWidth, extent);
        int triangles = commonOriginCulling.candidateSlots(beam, margin);
        hasManyTriangles = Integer.bitCount(triangles) >= MANY_TRIANGLES;
        long rays = 0;
        long multiple = 0;
        for (int i = from; triangles != 0 && i < end; i += LaneRays.WIDTH) {
            int requested = (int) (rayMask >>> i) & -1 >>> -LaneRays.WIDTH;
            if (requested != 0) {
                rays |= (long) (requested
                        & commonOriginCulling.candidateLines(lines, i, triangles, margin, entryBits, slots, firstSlot)) << i;
                multiple |= (long) commonOriginCulling.multipleLines << i;
            }
        }
        multipleRays = multiple;
        return rays;
    }

    private long testSeparately(int from, int end) {
        long rays = 0;
        long multiple = 0;
        for (int i = from; i < end; i += LaneRays.WIDTH) {
            for (int left = enteringRays[i / LaneRays.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int candidates = lines.candidateSlots(tree.vertex, leaf, extent, k);
                slots[k] = candidates;
                firstSlot[k] = Integer.numberOfTrailingZeros(candidates);
                rays |= (long) (-candidates >>> 31) << k;
                multiple |= (long) (-(candidates & candidates - 1) >>> 31) << k;
            }
        }
        multipleRays = multiple;
        return rays;
    }

    private long testWithCommonOrigin(int from, int end) {
        commonOriginCulling.setLeaf(tree.vertex, MeshTree.LEAF_FLOATS * leaf, lines.sharedX, lines.sharedY, lines.sharedZ,
                CommonOriginCulling.minVolume(lines.sharedWidth, extent));
        float margin = CommonOriginCulling.margin(lines.sharedWidth, extent);
        long rays = 0;
        long multiple = 0;
        for (int i = from; i < end; i += LaneRays.WIDTH) {
            for (int left = enteringRays[i / LaneRays.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int candidates = commonOriginCulling.candidateSlots(lines.stepX[k], lines.stepY[k], lines.stepZ[k], margin);
                slots[k] = candidates;
                firstSlot[k] = Integer.numberOfTrailingZeros(candidates);
                rays |= (long) (-candidates >>> 31) << k;
                multiple |= (long) (-(candidates & candidates - 1) >>> 31) << k;
            }
        }
        multipleRays = multiple;
        return rays;
    }
}
