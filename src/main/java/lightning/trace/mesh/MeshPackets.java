package lightning.trace.mesh;

import static jdk.incubator.vector.VectorOperators.F2D;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.NE;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.trace.solid.Lanes;
import lightning.trace.solid.Rays;

/**
 * What the rays of a packet meet of a mesh: {@link MeshProbe} in lanes, with the same bits. Scratch memory: one for each thread.
 *
 * <p>Rays that go much the same way are led through the tree together, as one beam against eight boxes; at a leaf each ray by itself
 * is tested against its box, and those that enter it against its eight triangles, one after the other. Other rays go through
 * the tree alone, against eight boxes at a time.
 */
public final class MeshPackets {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> EIGHT_INTS = IntVector.SPECIES_256;
    private static final VectorSpecies<Float> HALF =
            VectorSpecies.of(float.class, VectorShape.forBitSize(Lanes.SPECIES.vectorBitSize() / 2));
    /** Rays whose steps differ by more than this are no beam. */
    private static final float SPREAD = 0.25f;
    /** Nor are rays whose origins lie farther apart than this share of the mesh's largest coordinate. */
    private static final double WIDTH = 0.1;
    /** Fewer rays are asked alone. */
    private static final int FEW = 3;

    private final MeshLanes rays = new MeshLanes();
    private final MeshBeam beam = new MeshBeam();
    private final double[] vertex = new double[MeshTree.LEAF];
    private final double[] depth = new double[MeshTree.WIDTH];
    private final double[] best = new double[Rays.WIDTH];
    private final int[] triangle = new int[Rays.WIDTH];
    private final int[] in = new int[MeshTree.WIDTH];
    private int[] stack = new int[64];
    private int[] since = new int[64];
    private MeshTree tree;
    private boolean any;
    private int open;
    private int farthest;

    /**
     * Finds the nearest triangles of some rays of a packet.
     *
     * @param m      the map to the mesh's space at {@code m[at …]}
     * @param mask   which rays
     * @param limits how far each goes, {@code double[WIDTH]}
     * @return the rays that meet a triangle no farther than their limits: one bit for each
     */
    public int nearest(MeshSolid solid, double[] m, int at, Rays p, int mask, double[] limits) {
        return search(solid.tree, m, at, p, mask, limits, false);
    }

    /** The distance of the triangle that ray {@code i} meets first, the lowest among equals, where {@link #nearest} found any. */
    public double distance(int i) {
        return best[i];
    }

    /** That triangle. */
    public int triangle(int i) {
        return triangle[i];
    }

    /** Some rays of a packet that meet a triangle at less than their limits; all else as {@link #nearest}. */
    public int blocked(MeshSolid solid, double[] m, int at, Rays p, int mask, double[] limits) {
        return search(solid.tree, m, at, p, mask, limits, true);
    }

    private int search(MeshTree of, double[] m, int at, Rays p, int mask, double[] limits, boolean anyOne) {
        tree = of;
        any = anyOne;
        if (stack.length < of.stack) {
            stack = new int[of.stack];
            since = new int[of.stack];
        }
        int reached = rays.enter(of, m, at, p, mask, limits);
        if (reached == 0) {
            return 0;
        }
        for (int left = reached; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            best[i] = limits[i];
            triangle[i] = -1;
        }
        open = reached;
        beam.take(rays, reached);
        if (beam.spread <= SPREAD && beam.width <= WIDTH * of.reach && Integer.bitCount(reached) >= FEW) {
            together();
        } else {
            for (int left = reached; left != 0; left &= left - 1) {
                alone(Integer.numberOfTrailingZeros(left));
            }
        }
        int met = 0;
        for (int left = reached; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            met |= (triangle[i] >= 0 ? 1 : 0) << i;
        }
        return met;
    }

    /** Leads the open rays through the tree as one beam. */
    private void together() {
        reach();
        int top = push(0, beam.touches(tree, 0, farthest), beam.in, 0);
        while (top > 0 && open != 0) {
            top--;
            if (since[top] > farthest) {
                continue;
            }
            int ref = stack[top];
            int child = tree.child[ref];
            if (child >= 0) {
                top = push(child, beam.touches(tree, child, farthest), beam.in, top);
            } else {
                int mask = enters(MeshTree.NODE * (ref >> 3) + (ref & 7)) & open;
                if (mask != 0 && leaf(~child, mask)) {
                    reach();
                }
            }
        }
    }

    /** Leads ray {@code i} through the tree. */
    private void alone(int i) {
        int top = push(0, enters(0, i), in, 0);
        while (top > 0) {
            top--;
            if (since[top] > rays.far[i]) {
                continue;
            }
            int child = tree.child[stack[top]];
            if (child >= 0) {
                top = push(child, enters(child, i), in, top);
            } else if (leaf(~child, 1 << i) && any) {
                return;
            }
        }
    }

    /** Puts children of a node on the stack, the nearest last. */
    private int push(int node, int mask, int[] enters, int top) {
        int end = top;
        for (int left = mask; left != 0; left &= left - 1) {
            int c = Integer.numberOfTrailingZeros(left);
            int at = end++;
            for (; at > top && since[at - 1] < enters[c]; at--) {
                since[at] = since[at - 1];
                stack[at] = stack[at - 1];
            }
            since[at] = enters[c];
            stack[at] = MeshTree.WIDTH * node + c;
        }
        return end;
    }

    /** How far any open ray still goes. */
    private void reach() {
        int most = -1;
        for (int i = 0; i < Rays.WIDTH; i++) {
            most = Math.max(most, rays.far[i]);
        }
        farthest = most;
    }

    /** Which rays may meet the box of a child at {@code tree.box[i]}. */
    private int enters(int i) {
        float[] b = tree.box;
        FloatVector steep = FloatVector.fromArray(FLOATS, rays.steepX, 0);
        IntVector p = steep.fma(FloatVector.broadcast(FLOATS, b[i]), FloatVector.fromArray(FLOATS, rays.lowX, 0)).reinterpretAsInts();
        IntVector q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 8]), FloatVector.fromArray(FLOATS, rays.highX, 0)).reinterpretAsInts();
        IntVector enters = p.min(q).max(0);
        IntVector leaves = p.max(q).min(IntVector.fromArray(INTS, rays.far, 0));
        steep = FloatVector.fromArray(FLOATS, rays.steepY, 0);
        p = steep.fma(FloatVector.broadcast(FLOATS, b[i + 16]), FloatVector.fromArray(FLOATS, rays.lowY, 0)).reinterpretAsInts();
        q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 24]), FloatVector.fromArray(FLOATS, rays.highY, 0)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        steep = FloatVector.fromArray(FLOATS, rays.steepZ, 0);
        p = steep.fma(FloatVector.broadcast(FLOATS, b[i + 32]), FloatVector.fromArray(FLOATS, rays.lowZ, 0)).reinterpretAsInts();
        q = steep.fma(FloatVector.broadcast(FLOATS, b[i + 40]), FloatVector.fromArray(FLOATS, rays.highZ, 0)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        return (int) enters.compare(LE, leaves).toLong();
    }

    /** Which children of a node ray {@code i} may meet; writes {@link #in}. */
    private int enters(int node, int i) {
        float[] b = tree.box;
        int at = MeshTree.NODE * node;
        FloatVector steep = FloatVector.broadcast(EIGHT, rays.steepX[i]);
        IntVector p = FloatVector.fromArray(EIGHT, b, at).fma(steep, FloatVector.broadcast(EIGHT, rays.lowX[i])).reinterpretAsInts();
        IntVector q = FloatVector.fromArray(EIGHT, b, at + 8).fma(steep, FloatVector.broadcast(EIGHT, rays.highX[i])).reinterpretAsInts();
        IntVector enters = p.min(q).max(0);
        IntVector leaves = p.max(q).min(rays.far[i]);
        steep = FloatVector.broadcast(EIGHT, rays.steepY[i]);
        p = FloatVector.fromArray(EIGHT, b, at + 16).fma(steep, FloatVector.broadcast(EIGHT, rays.lowY[i])).reinterpretAsInts();
        q = FloatVector.fromArray(EIGHT, b, at + 24).fma(steep, FloatVector.broadcast(EIGHT, rays.highY[i])).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        steep = FloatVector.broadcast(EIGHT, rays.steepZ[i]);
        p = FloatVector.fromArray(EIGHT, b, at + 32).fma(steep, FloatVector.broadcast(EIGHT, rays.lowZ[i])).reinterpretAsInts();
        q = FloatVector.fromArray(EIGHT, b, at + 40).fma(steep, FloatVector.broadcast(EIGHT, rays.highZ[i])).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        enters.intoArray(in, 0);
        return (int) enters.compare(LE, leaves)
                .and(IntVector.fromArray(EIGHT_INTS, tree.child, MeshTree.WIDTH * node).compare(NE, MeshTree.NONE)).toLong();
    }

    /** Asks the triangles of a leaf for some rays; whether any ray meets one nearer than before. */
    private boolean leaf(int leaf, int mask) {
        for (int i = 0; i < MeshTree.LEAF; i += Lanes.COUNT) {
            ((DoubleVector) FloatVector.fromArray(HALF, tree.vertex, MeshTree.LEAF * leaf + i).convertShape(F2D, Lanes.SPECIES, 0))
                    .intoArray(vertex, i);
        }
        boolean nearer = false;
        for (int left = mask; left != 0; left &= left - 1) {
            int i = Integer.numberOfTrailingZeros(left);
            int slots = rays.signs(vertex, i, depth);
            if (slots != 0) {
                nearer |= take(i, leaf, slots);
            }
        }
        return nearer;
    }

    private boolean take(int i, int leaf, int slots) {
        boolean nearer = false;
        for (int left = slots; left != 0; left &= left - 1) {
            int s = Integer.numberOfTrailingZeros(left);
            double t = rays.put(i, depth[s], tree.vertex, MeshTree.LEAF * leaf + s);
            int id = tree.triangle[MeshTree.WIDTH * leaf + s];
            if (any ? t < best[i] : t < MeshRay.MISS && (t < best[i] || t == best[i] && (triangle[i] < 0 || id < triangle[i]))) {
                triangle[i] = id;
                nearer = true;
                if (any) {
                    rays.far[i] = -1;
                    open &= ~(1 << i);
                    return true;
                }
                best[i] = t;
                rays.limit(i, t);
            }
        }
        return nearer;
    }
}
