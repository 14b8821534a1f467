package lightning.render.trace.mesh;

import lightning.render.trace.solid.Rays;

/** Which rays that are led together may meet triangles of a leaf, and which triangles. Scratch memory: one for each thread. */
final class LeafRays {
    /** So many rays from one point that enter a leaf pay for what they have in common. */
    private static final int FAN = 2;

    private final MeshSight sight;
    private final LeafFan fan = new LeafFan();
    /** The rays of each packet that enter the leaf. */
    private final int[] enters;
    /** The rays that may meet triangles, and the slots of those. */
    final int[] ray;
    final int[] slots;
    private MeshTree tree;
    private int leaf;
    /** The longest side of the leaf's box. */
    private float extent;
    /** Written so that what it is made of is read. */
    float asked;

    /** @param most rays, whole packets */
    LeafRays(MeshSight sight, int most) {
        this.sight = sight;
        enters = new int[most / Rays.WIDTH];
        ray = new int[most];
        slots = new int[most];
    }

    /** The longest side of the box {@code b[i]}. */
    static float extent(float[] b, int i) {
        return Math.max(b[i + 8] - b[i], Math.max(b[i + 24] - b[i + 16], b[i + 40] - b[i + 32]));
    }

    /**
     * Asks a leaf whose box is {@code of.box[box]} of the rays {@code from … end − 1}, whole packets; how many of them may meet anything, which are
     * the first of {@link #ray}.
     *
     * @param set those that are asked, one bit for each
     */
    int find(MeshTree of, int at, int box, long set, int from, int end) {
        tree = of;
        leaf = at;
        float[] v = of.vertex;
        int first = MeshTree.LEAF * at;
        // Asks memory for the lines of the leaf before boxes are tested: a fifth less time for ways to a light.
        asked = v[first] + v[first + 16] + v[first + 32] + v[first + 48] + v[first + 64];
        extent = extent(of.box, box);
        int count = 0;
        for (int i = from; i < end; i += Rays.WIDTH) {
            int asking = (int) (set >>> i) & -1 >>> -Rays.WIDTH;
            int entering = asking == 0 ? 0 : sight.enters(of.box, box, i) & asking;
            enters[i / Rays.WIDTH] = entering;
            count += Integer.bitCount(entering);
        }
        // First all tests, then what comes of them: a processor guesses wrong only once where it would for every other ray.
        return sight.fan && count >= FAN ? together(from, end) : each(from, end);
    }

    private int each(int from, int end) {
        int n = 0;
        for (int i = from; i < end; i += Rays.WIDTH) {
            for (int left = enters[i / Rays.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int met = sight.meets(tree.vertex, leaf, extent, k);
                ray[n] = k;
                slots[n] = met;
                n += -met >>> 31;
            }
        }
        return n;
    }

    private int together(int from, int end) {
        fan.take(tree.vertex, MeshTree.LEAF * leaf, sight.startX[from], sight.startY[from], sight.startZ[from]);
        float margin = LeafFan.margin(sight.wide[from], extent);
        int n = 0;
        for (int i = from; i < end; i += Rays.WIDTH) {
            for (int left = enters[i / Rays.WIDTH]; left != 0; left &= left - 1) {
                int k = i + Integer.numberOfTrailingZeros(left);
                int met = fan.meets(sight.stepX[k], sight.stepY[k], sight.stepZ[k], margin);
                ray[n] = k;
                slots[n] = met;
                n += -met >>> 31;
            }
        }
        return n;
    }
}
