package lightning.render.trace.mesh;

import lightning.render.trace.solid.RayBatch;

/** Which rays that are led together may meet triangles of a leaf, and which triangles. Scratch memory: one for each thread. */
final class LeafRayFilter {
    /** So many rays from one point that enter a leaf pay for what they have in common. */
    private static final int MIN_COMMON_ORIGIN_RAYS = 2;

    private final MeshFloatLines lines;
    private final CommonOriginCulling commonOriginCulling = new CommonOriginCulling();
    /** The rays of each packet that enter the leaf. */
    private final int[] enteringRays;
    /** The rays that may meet triangles, and the slots of those. */
    final int[] ray;
    final int[] slots;
    private MeshTree tree;
    private int leaf;
    /** The longest side of the leaf's box. */
    private float extent;
    /** Written so that what it is made of is read. */
    float prefetchSink;

    /** @param capacity rays, whole packets */
    LeafRayFilter(MeshFloatLines lines, int capacity) {
        this.lines = lines;
        enteringRays = new int[capacity / RayBatch.WIDTH];
        ray = new int[capacity];
        slots = new int[capacity];
    }

    /** The longest side of the box {@code b[i]}. */
    static float extent(float[] b, int i) {
        return Math.max(b[i + 8] - b[i], Math.max(b[i + 24] - b[i + 16], b[i + 40] - b[i + 32]));
    }

    /**
     * Asks a leaf whose box is {@code of.box[box]} of the rays {@code from … end − 1}, whole packets; how many of them may meet anything, which are
     * the first of {@link #ray}.
     *
     * @param rayMask those that are asked, one bit for each
     */
    int findCandidates(MeshTree newTree, int at, int box, long rayMask, int from, int end) {
        tree = newTree;
        leaf = at;
        float[] v = newTree.vertex;
        int first = MeshTree.LEAF_FLOATS * at;
        // Asks memory for the lines of the leaf before boxes are tested: a fifth less time for ways to a light.
        prefetchSink = v[first] + v[first + 16] + v[first + 32] + v[first + 48] + v[first + 64];
        extent = extent(newTree.box, box);
        int count = 0;
        for (int i = from; i < end; i += RayBatch.WIDTH) {
            int requested = (int) (rayMask >>> i) & -1 >>> -RayBatch.WIDTH;
            int entering = requested == 0 ? 0 : lines.enteringRays(newTree.box, box, i) & requested;
            enteringRays[i / RayBatch.WIDTH] = entering;
            count += Integer.bitCount(entering);
        }
        // First all tests, then what comes of them: a processor guesses wrong only once where it would for every other ray.
        return lines.hasSharedStart && count >= MIN_COMMON_ORIGIN_RAYS ? testWithCommonOrigin(from, end) : testSeparately(from, end);
    }

    private int testSeparately(int from, int end) {
        int n = 0;
        for (int i = from; i < end; i += RayBatch.WIDTH) {
            for (int left = enteringRays[i / RayBatch.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int candidates = lines.candidateSlots(tree.vertex, leaf, extent, k);
                ray[n] = k;
                slots[n] = candidates;
                n += -candidates >>> 31;
            }
        }
        return n;
    }

    private int testWithCommonOrigin(int from, int end) {
        commonOriginCulling.setLeaf(tree.vertex, MeshTree.LEAF_FLOATS * leaf, lines.startX[from], lines.startY[from], lines.startZ[from]);
        float margin = CommonOriginCulling.margin(lines.lineWidth[from], extent);
        int n = 0;
        for (int i = from; i < end; i += RayBatch.WIDTH) {
            for (int left = enteringRays[i / RayBatch.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int candidates = commonOriginCulling.candidateSlots(lines.stepX[k], lines.stepY[k], lines.stepZ[k], margin);
                ray[n] = k;
                slots[n] = candidates;
                n += -candidates >>> 31;
            }
        }
        return n;
    }
}
