package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.ASHR;
import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.Initializer;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.LaneRays;
import org.jspecify.annotations.Nullable;

/**
 * Lane version of {@link MeshRayQuery} for groups of rays, with the same bits. Holds scratch memory: use one per thread.
 *
 * <p>A group is up to {@link #PACKETS} packets. If its rays are coherent, they traverse the BVH together, as one beam against
 * eight boxes. At a leaf, each packet is tested against the leaf's box, and the rays that enter it against its eight triangles,
 * one by one. A beam that visits many leaves without a hit is split while it descends: the rays that enter a node continue on
 * their own. If rays start far apart or diverge, each packet is traced on its own, and if its rays diverge too, each ray,
 * against eight boxes per test.
 * <pre>{@code
 * packets.beginGroup(solid, map, 0);
 * packets.addPacket(rays, mask, limits);
 * packets.findNearest();
 * }</pre>
 */
public final class MeshPacketTraversal {
    /** Maximum number of packets of a group: 64 rays. */
    public static final int PACKETS = 64 / LaneRays.WIDTH;

    private static final int MAX_RAYS = PACKETS * LaneRays.WIDTH;
    /** Maximum difference of the steps of rays in a beam. */
    private static final float MAX_STEP_SPREAD = 1;
    /** Maximum distance between the origins of rays in a beam, relative to the mesh's largest coordinate. */
    private static final double MAX_ORIGIN_SPREAD = 0.1;
    /** Minimum number of rays in a beam; fewer are traced one by one. */
    private static final int MIN_BEAM_RAYS = 3;
    /** Maximum number of nested beams; each has at most half as many rays as its parent. */
    private static final int MAX_BEAMS = 8;
    /** Leaves without a hit after which a beam tests at each node which of its rays enter it. */
    private static final int MAX_IDLE_LEAVES = 8;
    /** Minimum number of adjacent rays whose triangles are tested in lanes. */
    private static final int MIN_LANE_RAYS = 3;
    private static final int ALL_SLOTS = -1 >>> -MeshTree.WIDTH;
    private static final VectorSpecies<Integer> SLOTS = IntVector.SPECIES_256;

    private final MeshRayLanes rays = new MeshRayLanes(MAX_RAYS);
    private final MeshFloatLines lines = new MeshFloatLines(rays, MAX_RAYS);
    /** The beam of the group, and the smaller beams that it is split into. */
    private final MeshBeam[] beams = new MeshBeam[MAX_BEAMS];
    private final LeafTriangleLanes leafTriangles = new LeafTriangleLanes(rays, MAX_RAYS);
    private final LeafRayFilter leafFilter = new LeafRayFilter(lines, leafTriangles.slot, MAX_RAYS);
    private final double[] hitLimit = new double[MAX_RAYS];
    private final int[] triangle = new int[MAX_RAYS];
    /** Rays of the group that hit a triangle. */
    private long hitRays;
    /** Rays of each packet that traverse the BVH. */
    private final int[] activeMasks = new int[PACKETS];
    /** Active rays of the group: ray i of packet k is bit {@code k · WIDTH + i}. */
    private long activeRays;
    /** Rays too short to traverse the BVH. */
    private final int[] shortRays = new int[PACKETS];
    private int[] stack = new int[64];
    private int[] entryBits = new int[64];
    /** Beam of each node on the stack. */
    private byte[] stackBeam = new byte[64];
    private MeshTree tree;
    private double[] map;
    private int mapAt;
    private int count;
    /** Null if the mesh has no cutouts. */
    private @Nullable GroupAlphaTest alphaTest;
    private boolean anyHit;
    private int maxLimitBits;
    /** Number of leaves that the beam visited in which no ray may hit a triangle. */
    private int idleLeaves;

    public MeshPacketTraversal() {
        for (int i = 0; i < MAX_BEAMS; i++) {
            beams[i] = new MeshBeam();
        }
    }

    /**
     * Starts a new group.
     *
     * @param m transform to the mesh's space at {@code m[at …]}
     */
    @Initializer
    public void beginGroup(MeshSolid solid, double[] m, int at) {
        tree = solid.tree;
        map = m;
        mapAt = at;
        count = 0;
        alphaTest = null;
        if (stack.length < tree.stackSize) {
            stack = new int[tree.stackSize];
            entryBits = new int[tree.stackSize];
            stackBeam = new byte[tree.stackSize];
        }
    }

    /** Sets the alpha test that lets rays pass through holes of triangles. */
    public void setAlphaTest(GroupAlphaTest test) {
        alphaTest = test;
    }

    /**
     * Adds a packet to the group, which must have room for it.
     *
     * @param mask rays of the packet to trace, one bit each; not 0
     * @param limits maximum distance of each ray, {@code double[WIDTH]}
     */
    public void addPacket(LaneRays p, int mask, double[] limits) {
        int to = count * LaneRays.WIDTH;
        rays.addPacket(tree, map, mapAt, p, mask, to);
        System.arraycopy(limits, 0, hitLimit, to, LaneRays.WIDTH);
        activeMasks[count++] = mask;
    }

    /** Finds the nearest triangles within the rays' limits; {@link #hitMask} returns the rays that hit one. */
    public void findNearest() {
        search(false);
    }

    /** Finds the blocked rays, which {@link #hitMask} returns: rays that hit a triangle below their limits. */
    public void findBlocked() {
        search(true);
    }

    /** Returns the rays of packet {@code k} that hit a triangle, one bit each. */
    public int hitMask(int k) {
        return (int) (hitRays >>> k * LaneRays.WIDTH) & -1 >>> -LaneRays.WIDTH;
    }

    /**
     * Returns the distance of the triangle that ray {@code i} of packet {@code k} hits first, if {@link #hitMask} contains the
     * ray.
     */
    public double distance(int k, int i) {
        return hitLimit[k * LaneRays.WIDTH + i];
    }

    /** Returns the triangle that the ray hits first, the lowest among equal distances. */
    public int triangle(int k, int i) {
        return triangle[k * LaneRays.WIDTH + i];
    }

    private void search(boolean stopAtAnyHit) {
        anyHit = stopAtAnyHit;
        int end = count * LaneRays.WIDTH;
        hitRays = 0;
        lines.setRays(tree, activeMasks, shortRays, count, hitLimit, anyHit);
        activeRays = 0;
        for (int k = 0; k < count; k++) {
            activeRays |= (long) activeMasks[k] << k * LaneRays.WIDTH;
        }
        if (!traverseAsBeam(0, end)) {
            for (int i = 0; i < end; i += LaneRays.WIDTH) {
                if (activeMasks[i / LaneRays.WIDTH] != 0 && (count == 1 || !traverseAsBeam(i, i + LaneRays.WIDTH))) {
                    lines.prepareBoxTests();
                    for (int left = activeMasks[i / LaneRays.WIDTH]; left != 0; left &= left - 1) {
                        traverseRay(i + Integer.numberOfTrailingZeros(left), 0, 0);
                    }
                }
            }
        }
        for (int k = 0; k < count; k++) {
            for (int left = shortRays[k]; left != 0; left &= left - 1) {
                testAllLeaves(k * LaneRays.WIDTH + Integer.numberOfTrailingZeros(left));
            }
        }
    }

    /** Tests ray {@code i} against all leaves. */
    private void testAllLeaves(int i) {
        int leaves = tree.triangle.length / MeshTree.WIDTH;
        for (int leaf = 0; leaf < leaves; leaf++) {
            if (testTriangles(i, leaf, -1 >>> -MeshTree.WIDTH) && anyHit) {
                return;
            }
        }
    }

    /** Traverses the BVH with the active rays {@code i … end − 1}, whole packets, as one beam if they are coherent. */
    private boolean traverseAsBeam(int i, int end) {
        long rayMask = activeRays & -1L << i & -1L >>> -end;
        if (rayMask == 0) {
            return true;
        }
        if (Long.bitCount(rayMask) < MIN_BEAM_RAYS) {
            return false;
        }
        beams[0].setRays(lines, rayMask, i, end);
        if (beams[0].stepSpread > MAX_STEP_SPREAD || beams[0].originSpread > MAX_ORIGIN_SPREAD * tree.maxCoordinate) {
            return false;
        }
        traverseBeam(i, end);
        return true;
    }

    private void traverseBeam(int from, int end) {
        idleLeaves = 0;
        maxLimitBits = lines.maxLimitBits(from, end);
        int top = push(0, beams[0].enteredChildren(tree, 0, maxLimitBits), beams[0].entryBits, 0, 0);
        while (top > 0) {
            top--;
            long rayMask = beams[stackBeam[top]].rays & activeRays;
            if (entryBits[top] > maxLimitBits || rayMask == 0) {
                continue;
            }
            int ref = stack[top];
            int child = tree.child[ref];
            int box = MeshTree.NODE_FLOATS * (ref >> 3) + (ref & 7);
            if (child >= 0 && idleLeaves <= MAX_IDLE_LEAVES) {
                int b = stackBeam[top];
                top = push(child, beams[b].enteredChildren(tree, child, maxLimitBits), beams[b].entryBits, b, top);
            } else if (child >= 0) {
                lines.prepareBoxTests();
                top = splitBeam(child, lines.enteringRays(tree.box, box, rayMask, from, end), stackBeam[top], from, end, top);
            } else if (testLeaf(~child, box, rayMask, from, end, beams[stackBeam[top]], entryBits[top]) && !anyHit) {
                maxLimitBits = lines.maxLimitBits(from, end);
            }
        }
    }

    /**
     * Continues with the rays of a beam that enter a node: one by one if they are few, as a new beam if they are half of it or
     * less.
     */
    private int splitBeam(int node, long rayMask, int beam, int from, int end, int top) {
        int n = Long.bitCount(rayMask);
        if (n < MIN_BEAM_RAYS) {
            for (long left = rayMask; left != 0; left &= left - 1) {
                traverseRay(Long.numberOfTrailingZeros(left), node, top);
            }
            return top;
        }
        int b = beam;
        if (2 * n <= Long.bitCount(beams[b].rays)) {
            beams[++b].setRays(lines, rayMask, from, end);
        }
        return push(node, beams[b].enteredChildren(tree, node, maxLimitBits), beams[b].entryBits, b, top);
    }

    /**
     * Tests the triangles of a leaf, whose box is {@code tree.box[box]}, against rays of a beam. Returns whether any hit is
     * nearer than before.
     */
    private boolean testLeaf(int leaf, int box, long rayMask, int from, int end, MeshBeam beam, int enters) {
        long candidates = leafFilter.findCandidates(tree, leaf, box, rayMask, from, end, beam, enters);
        idleLeaves += candidates == 0 ? 1 : 0;
        boolean nearer = false;
        for (long left = candidates; left != 0;) {
            int h = Long.numberOfTrailingZeros(left) & -LeafTriangleLanes.RAYS;
            nearer |= testRays(h, leaf, (int) (candidates >>> h) & ALL_SLOTS);
            left &= h + LeafTriangleLanes.RAYS == Long.SIZE ? 0 : -1L << h + LeafTriangleLanes.RAYS;
        }
        return nearer;
    }

    /** Tests rays {@code h … h + 7} of a set against the triangles of a leaf that they may hit. */
    private boolean testRays(int h, int leaf, int mask) {
        boolean nearer = false;
        int left = mask;
        if (Integer.bitCount(mask) < MIN_LANE_RAYS) {
            for (; left != 0; left &= left - 1) {
                int i = h + Integer.numberOfTrailingZeros(left);
                nearer |= testTriangles(i, leaf, leafFilter.slots[i]);
            }
            return nearer;
        }
        while (true) {
            leafTriangles.computeDistances(tree, leaf, h, left);
            int accepted = alphaTest == null ? acceptHits(h, leaf, left) : acceptHitsSingly(h, leaf, left);
            nearer |= accepted != 0;
            left &= (int) (leafFilter.multipleRays >>> h);
            if (anyHit) {
                left &= ~accepted;
            }
            int more = 0;
            for (; left != 0; left &= left - 1) {
                int i = h + Integer.numberOfTrailingZeros(left);
                int slots = leafFilter.slots[i] & leafFilter.slots[i] - 1;
                leafFilter.slots[i] = slots;
                leafTriangles.slot[i] = Integer.numberOfTrailingZeros(slots);
                more |= slots != 0 ? left & -left : 0;
            }
            if (more == 0) {
                return nearer;
            }
            left = more;
        }
    }

    /** Accepts hits of rays {@code h … h + 7} of a set that are nearer than before; returns these rays. */
    private int acceptHits(int h, int leaf, int mask) {
        int nearer = 0;
        int equal = 0;
        for (int part = 0; part < LeafTriangleLanes.RAYS; part += DoubleLanes.COUNT) {
            DoubleVector t = DoubleVector.fromArray(DoubleLanes.SPECIES, leafTriangles.distance, h + part);
            DoubleVector limit = DoubleVector.fromArray(DoubleLanes.SPECIES, hitLimit, h + part);
            nearer |= (int) t.compare(LT, limit).toLong() << part;
            equal |= (int) t.compare(EQ, limit).toLong() << part;
        }
        nearer &= mask;
        int accepted = nearer;
        if (!anyHit) {
            for (int left = equal & mask; left != 0; left &= left - 1) {
                int i = h + Integer.numberOfTrailingZeros(left);
                int id = MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + leafTriangles.slot[i]]);
                if (hitLimit[i] < MeshRay.MISS && (!hasHit(i) || id < triangle[i])) {
                    accepted |= left & -left;
                }
            }
        }
        if (accepted == 0) {
            return 0;
        }
        IntVector ids = IntVector.fromArray(SLOTS, leafTriangles.slot, h)
                .selectFrom(IntVector.fromArray(SLOTS, tree.triangle, MeshTree.WIDTH * leaf));
        ids = ids.lanewise(ASHR, MeshTree.CORNER_BITS);
        IntVector.fromArray(SLOTS, triangle, h).blend(ids, VectorMask.fromLong(SLOTS, accepted)).intoArray(triangle, h);
        hitRays |= (long) accepted << h;
        if (anyHit) {
            activeRays &= ~((long) accepted << h);
            return accepted;
        }
        for (int part = 0; part < LeafTriangleLanes.RAYS; part += DoubleLanes.COUNT) {
            DoubleVector.fromArray(DoubleLanes.SPECIES, hitLimit, h + part)
                    .blend(DoubleVector.fromArray(DoubleLanes.SPECIES, leafTriangles.distance, h + part),
                            VectorMask.fromLong(DoubleLanes.SPECIES, accepted >>> part))
                    .intoArray(hitLimit, h + part);
        }
        lines.setLimits(h, accepted, leafTriangles.distance);
        return accepted;
    }

    private int acceptHitsSingly(int h, int leaf, int mask) {
        int accepted = 0;
        for (int left = mask; left != 0; left &= left - 1) {
            int i = h + Integer.numberOfTrailingZeros(left);
            int id = MeshTree.id(tree.triangle[MeshTree.WIDTH * leaf + leafTriangles.slot[i]]);
            accepted |= acceptHit(i, id, leafTriangles.distance[i]) ? left & -left : 0;
        }
        return accepted;
    }

    /** Traverses the subtree of a node with ray {@code i}; the stack is in use up to {@code bottom}. */
    private void traverseRay(int i, int node, int bottom) {
        int top = push(node, lines.enteredChildren(tree.box, node, i), lines.entryBits, 0, bottom);
        while (top > bottom) {
            top--;
            if (entryBits[top] > lines.limitBits[i]) {
                continue;
            }
            int ref = stack[top];
            int next = tree.child[ref];
            while (next >= 0) {
                int mask = lines.enteredChildren(tree.box, next, i);
                if (mask == 0 || (mask & mask - 1) != 0) {
                    top = push(next, mask, lines.entryBits, 0, top);
                    ref = -1;
                    break;
                }
                ref = MeshTree.WIDTH * next + Integer.numberOfTrailingZeros(mask);
                next = tree.child[ref];
            }
            if (ref >= 0) {
                int slots = lines.candidateSlots(tree.vertex, ~next,
                        LeafRayFilter.extent(tree.box, MeshTree.NODE_FLOATS * (ref >> 3) + (ref & 7)), i);
                if (slots != 0 && testTriangles(i, ~next, slots) && anyHit) {
                    return;
                }
            }
        }
    }

    /** Pushes children of a node onto the stack, the nearest last. */
    private int push(int node, int mask, int[] enters, int beam, int top) {
        int end = top;
        for (int left = mask; left != 0; left &= left - 1) {
            int c = Integer.numberOfTrailingZeros(left);
            int in = enters[c];
            int at = end++;
            for (; at > top && entryBits[at - 1] < in; at--) {
                entryBits[at] = entryBits[at - 1];
                stack[at] = stack[at - 1];
            }
            stackBeam[end - 1] = (byte) beam;
            entryBits[at] = in;
            stack[at] = MeshTree.WIDTH * node + c;
        }
        return end;
    }

    private boolean testTriangles(int i, int leaf, int slots) {
        boolean nearer = false;
        for (int left = slots; left != 0; left &= left - 1) {
            int s = Integer.numberOfTrailingZeros(left);
            int reference = tree.triangle[MeshTree.WIDTH * leaf + s];
            if (reference < 0) {
                continue;
            }
            int last = MeshTree.lastCorner(reference);
            int first = MeshTree.LEAF_FLOATS * leaf + s;
            // The order of the other two corners does not change the distance.
            double t = rays.distance(i, tree.vertex, first + MeshTree.CORNER_FLOATS * (last == 2 ? 0 : last + 1),
                    first + MeshTree.CORNER_FLOATS * (last == 0 ? 2 : last - 1), first + MeshTree.CORNER_FLOATS * last);
            nearer |= acceptHit(i, MeshTree.id(reference), t);
            if (nearer && anyHit) {
                return true;
            }
        }
        return nearer;
    }

    /** Accepts a hit if it counts and is nearer than before. */
    private boolean acceptHit(int i, int id, double t) {
        if ((anyHit ? t < hitLimit[i] : t < MeshRay.MISS && (t < hitLimit[i] || t == hitLimit[i] && (!hasHit(i) || id < triangle[i])))
                && (alphaTest == null || !alphaTest.isHole(i, id, t))) {
            triangle[i] = id;
            hitRays |= 1L << i;
            if (anyHit) {
                activeRays &= ~(1L << i);
            } else {
                hitLimit[i] = t;
                lines.setLimit(i, t);
            }
            return true;
        }
        return false;
    }

    private boolean hasHit(int i) {
        return (hitRays >>> i & 1) != 0;
    }
}
