package lightning.render.engine.lanes;

import java.util.Arrays;
import lightning.render.trace.Geometry;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.Surface;
import lightning.render.trace.solid.Form;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.Candidates;

/**
 * Traces packets of rays. Holds scratch memory: one for each thread.
 *
 * <p>A packet is a way to run, not an approximation: each lane's answer is that of the scalar
 * functions of {@link Form} and {@link Surface}, bit for bit. Boxes are tested in floats and only
 * reject; whatever they let through is decided in doubles.
 *
 * <p>Directions have a length from 1e−30 to 1e30; origins are the camera or lie within the box of the scene.
 */
public final class PacketTracer {
    /** Up to this many primitives the boxes of all are tested in turn, which the tree beats from about forty. */
    static final int FEW = 32;

    /** Up to this many primitives are tested without their boxes, which cost as much as one or two primitives. */
    static final int BARE = 3;

    private final PrimitiveTable primitives;
    private final Bvh bvh;
    private final BoxLanes box = new BoxLanes();
    private final SolidLanes solid;
    private final SurfaceLanes surface;
    private final int[] stack;
    private final int[] stackMask;
    private final int[] masks = new int[2];
    private final Candidates all;
    private int lastOccluder = -1;

    public PacketTracer(Geometry geometry) {
        this(geometry.bvh(), FEW);
    }

    public PacketTracer(Bvh bvh, int few) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        solid = new SolidLanes(primitives);
        surface = new SurfaceLanes(primitives);
        stack = new int[bvh.depth + 1];
        stackMask = new int[bvh.depth + 1];
        all = primitives.count <= Math.max(few, 1) ? Candidates.all(bvh) : null;
    }

    /** Finds the nearest hit of the first {@code live} lanes; writes {@code t} and {@code primitive}. */
    public void nearest(RayPacket p, int live) {
        if (all != null) {
            nearest(p, live, all);
            return;
        }
        box.enter(p);
        solid.begin(p);
        int top = 0;
        int next = 0;
        int mask = lanes(live);
        int lane = 0;
        while (true) {
            if (next >= 0) {
                box.hits(bvh.boxes, 12 * next, 2, masks);
                int first = masks[0] & mask;
                int second = masks[1] & mask;
                if (first != 0 && second != 0) {
                    int near = forwards(p, lane, bvh.axis[next]) ? 0 : 1;
                    stack[top] = bvh.child[2 * next + 1 - near];
                    stackMask[top++] = near == 0 ? second : first;
                    mask = near == 0 ? first : second;
                    next = bvh.child[2 * next + near];
                    continue;
                }
                if ((first | second) != 0) {
                    mask = first | second;
                    next = bvh.child[2 * next + (first != 0 ? 0 : 1)];
                    continue;
                }
            } else {
                meet(p, ~next, mask);
            }
            do {
                if (top == 0) {
                    solid.write(p);
                    return;
                }
                next = stack[--top];
                mask = stackMask[top];
                // The boxes of an inner node's children are tested anyway.
                mask = next < 0 ? (int) box.hits(bvh.boxes, bvh.leaf[~next]) & mask : mask;
            } while (mask == 0);
        }
    }

    /**
     * The same where only the {@code candidates} can be met.
     *
     * @param candidates of a beam that all of the packet's rays are in
     */
    public void nearest(RayPacket p, int live, Candidates candidates) {
        if (candidates.tooMany) {
            nearest(p, live);
            return;
        }
        solid.begin(p);
        int lanes = lanes(live);
        if (candidates.count <= BARE) {
            for (int c = 0; c < candidates.count; c++) {
                solid.nearer(p, candidates.primitive[c], lanes);
            }
        } else {
            box.enter(p);
            int[] masks = candidates.masks;
            box.hits(candidates.boxes, 0, candidates.count, masks);
            boolean met = false;
            for (int c = 0; c < candidates.count; c++) {
                int mask = masks[c] & lanes;
                if (mask != 0 && met) {
                    mask &= (int) box.hits(candidates.boxes, 6 * c);
                }
                if (mask != 0) {
                    met |= meet(p, candidates.primitive[c], mask);
                }
            }
        }
        solid.write(p);
    }

    /**
     * Which of the first {@code live} lanes meet any primitive at a distance below their {@code limit}.
     *
     * @return one bit for each lane, the lowest for lane 0
     */
    public int blocked(RayPacket p, int live) {
        if (all != null) {
            return blocked(p, live, all);
        }
        box.enter(p);
        box.limit(p.limit);
        int open = lanes(live);
        int lanes = open;
        if (lastOccluder >= 0) {
            open &= ~blockedBy(p, lastOccluder, (int) box.hits(bvh.boxes, bvh.leaf[lastOccluder]) & open);
        }
        int top = 0;
        stack[top] = 0;
        stackMask[top++] = open;
        while (top > 0 && open != 0) {
            int next = stack[--top];
            int mask = stackMask[top] & open;
            while (mask != 0 && next >= 0) {
                box.hits(bvh.boxes, 12 * next, 2, masks);
                int first = masks[0] & mask;
                int second = masks[1] & mask;
                if (first != 0 && second != 0) {
                    stack[top] = bvh.child[2 * next + 1];
                    stackMask[top++] = second;
                }
                mask = first != 0 ? first : second;
                next = bvh.child[2 * next + (first != 0 ? 0 : 1)];
            }
            if (mask != 0 && ~next != lastOccluder) {
                open &= ~blockedBy(p, ~next, mask);
            }
        }
        return lanes & ~open;
    }

    /**
     * The same where only the {@code candidates} can block.
     *
     * @param candidates of a beam that all of the packet's rays are in, up to their limits
     */
    public int blocked(RayPacket p, int live, Candidates candidates) {
        if (candidates.tooMany) {
            return blocked(p, live);
        }
        int lanes = lanes(live);
        int open = lanes;
        int[] masks = candidates.masks;
        if (candidates.count <= BARE) {
            Arrays.fill(masks, 0, candidates.count, lanes);
        } else {
            box.enter(p);
            box.limit(p.limit);
            box.hits(candidates.boxes, 0, candidates.count, masks);
        }
        for (int c = 0; c < candidates.count && open != 0; c++) {
            int blocked = blockedBy(p, candidates.primitive[c], masks[c] & open);
            open &= ~blocked;
            if (blocked != 0) {
                candidates.promote(c);
            }
        }
        return lanes & ~open;
    }

    private int blockedBy(RayPacket p, int s, int mask) {
        if (mask == 0) {
            return 0;
        }
        int blocked = solid.below(p, s, mask);
        lastOccluder = blocked != 0 ? s : lastOccluder;
        return blocked;
    }

    private boolean meet(RayPacket p, int s, int mask) {
        boolean nearer = solid.nearer(p, s, mask);
        if (nearer) {
            box.limit(p.t);
        }
        return nearer;
    }

    private static int lanes(int live) {
        return -1 >>> -live;
    }

    static boolean forwards(RayPacket p, int lane, int axis) {
        return (axis == 0 ? p.dx : axis == 1 ? p.dy : p.dz)[lane] > 0;
    }

    /** For lanes whose {@code primitive} is known without a search: writes {@code t}. */
    public void distances(RayPacket p, int live) {
        int left = 0;
        for (int i = 0; i < live; i++) {
            p.t[i] = Form.MISS;
            left |= p.primitive[i] >= 0 ? 1 << i : 0;
        }
        while (left != 0) {
            int s = p.primitive[Integer.numberOfTrailingZeros(left)];
            left &= ~solid.distances(p, s, left);
        }
    }

    /** Computes the surfaces of those of the first {@code live} lanes that hit a primitive. */
    public void surfaces(RayPacket p, int live, SurfacePacket out) {
        surface.at(p, live, out);
    }

    /** Where they lie in the own space of the primitive, alone. */
    public void ownPoints(RayPacket p, int live, SurfacePacket out) {
        surface.own(p, live, out);
    }
}
