package lightning.render.trace.mesh;

import java.util.Arrays;
import lightning.render.trace.solid.Rays;

/**
 * What the rays of a group meet of a mesh: {@link MeshProbe} in lanes, with the same bits. Scratch memory: one for each thread.
 *
 * <p>A group is up to {@link #PACKETS} packets. Where all its rays go much the same way they are led through the tree together, as one beam
 * against eight boxes; at a leaf the rays of a packet are tested against its box, and those that enter it against its eight triangles, one after the
 * other. A beam that comes to many leaves in vain parts on its way down: those rays that enter a node go on by themselves. Where rays begin
 * apart or go very different ways each packet is led by itself, and where that does, each ray, against eight boxes at a time.
 *
 * <pre>{@code
 * packets.begin(solid, map, 0);
 * packets.add(rays, mask, limits);
 * packets.nearest();
 * }</pre>
 */
public final class MeshPackets {
    /** How many packets a group has at most: 64 rays. */
    public static final int PACKETS = 64 / Rays.WIDTH;

    private static final int MOST = PACKETS * Rays.WIDTH;
    /** Rays whose steps differ by more than this are no beam. */
    private static final float SPREAD = 1;
    /** Nor are rays whose origins lie farther apart than this share of the mesh's largest coordinate. */
    private static final double WIDTH = 0.1;
    /** Fewer rays are asked alone. */
    private static final int FEW = 3;
    /** Each beam has at most half as many rays as the one that it is a part of. */
    private static final int PARTS = 8;
    /** A beam that came to more leaves than this in vain is asked at each node which of its rays enter it. */
    private static final int PATIENCE = 8;

    private final MeshLanes rays = new MeshLanes(MOST);
    private final MeshSight sight = new MeshSight(rays, MOST);
    /** The beam of all, and those of ever fewer rays that it parts into on its way down. */
    private final MeshBeam[] beams = new MeshBeam[PARTS];
    private final LeafRays near = new LeafRays(sight, MOST);
    private final double[] best = new double[MOST];
    private final int[] triangle = new int[MOST];
    private final int[] met = new int[PACKETS];
    /** Those rays of each packet that are led through the tree. */
    private final int[] open = new int[PACKETS];
    /** Those of the group that are still asked: ray i of packet k is bit {@code k · WIDTH + i}. */
    private long asked;
    /** Those too short to be led through the tree. */
    private final int[] brief = new int[PACKETS];
    private int[] stack = new int[64];
    private int[] since = new int[64];
    /** The beam of each node that was put aside. */
    private byte[] within = new byte[64];
    private MeshTree tree;
    private double[] map;
    private int mapAt;
    private int count;
    /** Null where the mesh has no holes. */
    private GroupSieve sieve;
    private boolean any;
    /** Whether what is met is noted, and stops no ray. */
    private boolean every;
    private int crossings;
    private int[] crossingRay = new int[MOST];
    private int[] crossingTriangle = new int[MOST];
    private double[] crossingDistance = new double[MOST];
    private int farthest;
    /** How many leaves the beam came to where no ray may meet anything. */
    private int idle;

    public MeshPackets() {
        for (int i = 0; i < PARTS; i++) {
            beams[i] = new MeshBeam();
        }
    }

    /**
     * Begins a group.
     *
     * @param m the map to the mesh's space at {@code m[at …]}
     */
    public void begin(MeshSolid solid, double[] m, int at) {
        tree = solid.tree;
        map = m;
        mapAt = at;
        count = 0;
        sieve = null;
        if (stack.length < tree.stack) {
            stack = new int[tree.stack];
            since = new int[tree.stack];
            within = new byte[tree.stack];
        }
    }

    /** Lets the rays of the group pass triangles where they have holes. */
    public void sift(GroupSieve by) {
        sieve = by;
    }

    /**
     * Adds a packet to the group, which has room for it.
     *
     * @param mask   which of its rays, one bit for each; not 0
     * @param limits how far each goes, {@code double[WIDTH]}
     */
    public void add(Rays p, int mask, double[] limits) {
        int to = count * Rays.WIDTH;
        rays.take(tree, map, mapAt, p, mask, to);
        System.arraycopy(limits, 0, best, to, Rays.WIDTH);
        open[count++] = mask;
    }

    /** Finds the nearest triangles, which are no farther than the rays' limits; {@link #met} tells whose there are. */
    public void nearest() {
        search(false);
    }

    /** Finds whose way is blocked, which {@link #met} tells: rays that meet a triangle at less than their limits. */
    public void blocked() {
        search(true);
    }

    /** Finds all triangles that rays meet at less than their limits. */
    public void cross() {
        every = true;
        crossings = 0;
        search(true);
        every = false;
    }

    /** How many there are for all rays, in any order. */
    public int crossings() {
        return crossings;
    }

    /** The ray of one of them: ray i of packet k has the number {@code k · WIDTH + i}. */
    public int crossingRay(int n) {
        return crossingRay[n];
    }

    public int crossingTriangle(int n) {
        return crossingTriangle[n];
    }

    public double crossingDistance(int n) {
        return crossingDistance[n];
    }

    /** The rays of packet {@code k} that meet a triangle: one bit for each. */
    public int met(int k) {
        return met[k];
    }

    /** The distance of the triangle that ray {@code i} of packet {@code k} meets first, the lowest among equals, where it {@link #met} any. */
    public double distance(int k, int i) {
        return best[k * Rays.WIDTH + i];
    }

    /** That triangle. */
    public int triangle(int k, int i) {
        return triangle[k * Rays.WIDTH + i];
    }

    private void search(boolean anyOne) {
        any = anyOne;
        int end = count * Rays.WIDTH;
        Arrays.fill(met, 0, count, 0);
        sight.enter(tree, open, brief, count, best, any);
        asked = 0;
        for (int k = 0; k < count; k++) {
            asked |= (long) open[k] << k * Rays.WIDTH;
        }
        if (!together(0, end)) {
            for (int i = 0; i < end; i += Rays.WIDTH) {
                if (open[i / Rays.WIDTH] != 0 && (count == 1 || !together(i, i + Rays.WIDTH))) {
                    for (int left = open[i / Rays.WIDTH]; left != 0; left &= left - 1) {
                        alone(i + Integer.numberOfTrailingZeros(left), 0, 0);
                    }
                }
            }
        }
        for (int k = 0; k < count; k++) {
            for (int left = brief[k]; left != 0; left &= left - 1) {
                everywhere(k * Rays.WIDTH + Integer.numberOfTrailingZeros(left));
            }
        }
    }

    /** Asks all leaves for ray {@code i}. */
    private void everywhere(int i) {
        int leaves = tree.triangle.length / MeshTree.WIDTH;
        for (int leaf = 0; leaf < leaves; leaf++) {
            if (take(i, leaf, -1 >>> -MeshTree.WIDTH) && any) {
                return;
            }
        }
    }

    /** Leads the open rays {@code i … end − 1}, whole packets, through the tree as one beam, if they are one. */
    private boolean together(int i, int end) {
        long set = asked & -1L << i & -1L >>> -end;
        if (set == 0) {
            return true;
        }
        if (Long.bitCount(set) < FEW) {
            return false;
        }
        beams[0].take(sight, set, i, end);
        if (beams[0].spread > SPREAD || beams[0].width > WIDTH * tree.reach) {
            return false;
        }
        lead(i, end);
        return true;
    }

    private void lead(int from, int end) {
        idle = 0;
        farthest = sight.reach(from, end);
        int top = push(0, beams[0].touches(tree, 0, farthest), beams[0].in, 0, 0);
        while (top > 0) {
            top--;
            long set = beams[within[top]].rays & asked;
            if (since[top] > farthest || set == 0) {
                continue;
            }
            int ref = stack[top];
            int child = tree.child[ref];
            int box = MeshTree.NODE * (ref >> 3) + (ref & 7);
            if (child >= 0 && idle <= PATIENCE) {
                int b = within[top];
                top = push(child, beams[b].touches(tree, child, farthest), beams[b].in, b, top);
            } else if (child >= 0) {
                top = part(child, sight.enters(tree.box, box, set, from, end), within[top], from, end, top);
            } else if (leaf(~child, box, set, from, end) && !any) {
                farthest = sight.reach(from, end);
            }
        }
    }

    /** Goes on with those rays of a beam that enter a node: alone where they are few, as a beam of their own where they are half of it or less. */
    private int part(int node, long set, int beam, int from, int end, int top) {
        int n = Long.bitCount(set);
        if (n < FEW) {
            for (long left = set; left != 0; left &= left - 1) {
                alone(Long.numberOfTrailingZeros(left), node, top);
            }
            return top;
        }
        int b = beam;
        if (2 * n <= Long.bitCount(beams[b].rays)) {
            beams[++b].take(sight, set, from, end);
        }
        return push(node, beams[b].touches(tree, node, farthest), beams[b].in, b, top);
    }

    /** Asks the triangles of a leaf whose box is {@code tree.box[box]} for rays that are led together; whether any is nearer than before. */
    private boolean leaf(int leaf, int box, long set, int from, int end) {
        int n = near.find(tree, leaf, box, set, from, end);
        idle += n == 0 ? 1 : 0;
        boolean nearer = false;
        for (int k = 0; k < n; k++) {
            nearer |= take(near.ray[k], leaf, near.slots[k]);
        }
        return nearer;
    }

    /** Leads ray {@code i} through what is below a node; the stack is in use up to {@code bottom}. */
    private void alone(int i, int node, int bottom) {
        int top = push(node, sight.children(tree.box, node, i), sight.in, 0, bottom);
        while (top > bottom) {
            top--;
            if (since[top] > sight.far[i]) {
                continue;
            }
            int ref = stack[top];
            int next = tree.child[ref];
            while (next >= 0) {
                int mask = sight.children(tree.box, next, i);
                if (mask == 0 || (mask & mask - 1) != 0) {
                    top = push(next, mask, sight.in, 0, top);
                    ref = -1;
                    break;
                }
                ref = MeshTree.WIDTH * next + Integer.numberOfTrailingZeros(mask);
                next = tree.child[ref];
            }
            if (ref >= 0) {
                int slots = sight.meets(tree.vertex, ~next, LeafRays.extent(tree.box, MeshTree.NODE * (ref >> 3) + (ref & 7)), i);
                if (slots != 0 && take(i, ~next, slots) && any) {
                    return;
                }
            }
        }
    }

    /** Puts children of a node on the stack, the nearest last. */
    private int push(int node, int mask, int[] enters, int beam, int top) {
        int end = top;
        for (int left = mask; left != 0; left &= left - 1) {
            int c = Integer.numberOfTrailingZeros(left);
            int in = enters[c];
            int at = end++;
            for (; at > top && since[at - 1] < in; at--) {
                since[at] = since[at - 1];
                stack[at] = stack[at - 1];
            }
            within[end - 1] = (byte) beam;
            since[at] = in;
            stack[at] = MeshTree.WIDTH * node + c;
        }
        return end;
    }

    private boolean take(int i, int leaf, int slots) {
        boolean nearer = false;
        for (int left = slots; left != 0; left &= left - 1) {
            int s = Integer.numberOfTrailingZeros(left);
            double t = rays.distance(i, tree.vertex, MeshTree.LEAF * leaf + s);
            int id = tree.triangle[MeshTree.WIDTH * leaf + s];
            if (every) {
                note(i, id, t);
            } else if ((any ? t < best[i] : t < MeshRay.MISS && (t < best[i] || t == best[i] && (!isMet(i) || id < triangle[i])))
                    && (sieve == null || !sieve.passes(i, id, t))) {
                triangle[i] = id;
                met[i / Rays.WIDTH] |= 1 << i % Rays.WIDTH;
                if (any) {
                    asked &= ~(1L << i);
                    return true;
                }
                best[i] = t;
                sight.limit(i, t);
                nearer = true;
            }
        }
        return nearer;
    }

    private void note(int i, int id, double t) {
        if (!(t < best[i])) {
            return;
        }
        if (crossings == crossingRay.length) {
            crossingRay = Arrays.copyOf(crossingRay, 2 * crossings);
            crossingTriangle = Arrays.copyOf(crossingTriangle, 2 * crossings);
            crossingDistance = Arrays.copyOf(crossingDistance, 2 * crossings);
        }
        crossingRay[crossings] = i;
        crossingTriangle[crossings] = id;
        crossingDistance[crossings++] = t;
    }

    private boolean isMet(int i) {
        return (met[i / Rays.WIDTH] >>> i % Rays.WIDTH & 1) != 0;
    }
}
