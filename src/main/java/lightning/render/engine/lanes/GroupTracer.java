package lightning.render.engine.lanes;

import lightning.render.trace.Geometry;
import lightning.render.trace.mesh.MeshPackets;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.Candidates;

/**
 * Traces packets in groups, for scenes with meshes: a group goes through the tree as packets do ({@link PacketTracer}), each of them against each
 * box, but asks a mesh all at once. Sets of rays are the bits of a {@code long}, as those of {@link MeshGroup}. Holds scratch memory: one for
 * each thread.
 */
final class GroupTracer {
    /** How many packets a group has at most. */
    static final int MOST = MeshPackets.PACKETS;

    private static final int W = RayPacket.WIDTH;

    /** The packets, filled by who asks: the first of them up to those that a set names. */
    final RayPacket[] packets = new RayPacket[MOST];
    private final PrimitiveTable primitives;
    private final Bvh bvh;
    private final BoxLanes[] box = new BoxLanes[MOST];
    private final SolidLanes solid;
    private final int[] stack;
    private final long[] stackSet;
    private final int[] two = new int[2];
    /** Which rays enter the two children of a node. */
    private final long[] entered = new long[2];
    private final int[][] masks = new int[MOST][0];
    private final Candidates all;
    private int lastOccluder = -1;

    GroupTracer(Geometry geometry) {
        this(geometry.bvh(), PacketTracer.FEW);
    }

    GroupTracer(Bvh bvh, int few) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        solid = new SolidLanes(primitives);
        stack = new int[bvh.depth + 1];
        stackSet = new long[bvh.depth + 1];
        all = primitives.count <= Math.max(few, 1) ? Candidates.all(bvh) : null;
        for (int k = 0; k < MOST; k++) {
            packets[k] = new RayPacket();
            box[k] = new BoxLanes();
        }
    }

    /** The first packet of a set. */
    private static int first(long set) {
        return Long.numberOfTrailingZeros(set) / W;
    }

    /** The set without packet {@code k} and those before. */
    private static long after(long set, int k) {
        return k + 1 == MOST ? 0 : set & -1L << (k + 1) * W;
    }

    /**
     * Finds the nearest hits of a set of rays, not empty; writes {@code t}, {@code primitive} and {@code part}.
     *
     * @param candidates of a beam that all of the rays are in
     */
    void nearest(long set, Candidates candidates) {
        for (long left = set; left != 0; left = after(left, first(left))) {
            solid.begin(packets[first(left)]);
        }
        if (!candidates.tooMany) {
            nearestOf(set, candidates);
        } else if (all != null) {
            nearestOf(set, all);
        } else {
            search(set);
        }
        for (long left = set; left != 0; left = after(left, first(left))) {
            solid.write(packets[first(left)]);
        }
    }

    private void nearestOf(long set, Candidates candidates) {
        if (candidates.count <= PacketTracer.BARE) {
            for (int c = 0; c < candidates.count; c++) {
                nearer(candidates.primitive[c], set);
            }
            return;
        }
        touch(set, candidates, false);
        int met = 0;
        for (int c = 0; c < candidates.count; c++) {
            long asked = 0;
            for (long left = set; left != 0; left = after(left, first(left))) {
                int k = first(left);
                int mask = masks[k][c] & MeshGroup.of(set, k);
                if (mask != 0 && (met >>> k & 1) != 0) {
                    mask &= (int) box[k].hits(candidates.boxes, 6 * c);
                }
                asked |= (long) mask << k * W;
            }
            if (asked != 0) {
                met |= meet(candidates.primitive[c], asked);
            }
        }
    }

    /** Tests the boxes of all candidates. */
    private void touch(long set, Candidates candidates, boolean limited) {
        for (long left = set; left != 0; left = after(left, first(left))) {
            int k = first(left);
            if (masks[k].length < candidates.count) {
                masks[k] = new int[candidates.primitive.length];
            }
            box[k].enter(packets[k]);
            if (limited) {
                box[k].limit(packets[k].limit);
            }
            box[k].hits(candidates.boxes, 0, candidates.count, masks[k]);
        }
    }

    private void search(long all) {
        for (long left = all; left != 0; left = after(left, first(left))) {
            box[first(left)].enter(packets[first(left)]);
        }
        int top = 0;
        int next = 0;
        long set = all;
        RayPacket guide = packets[first(all)];
        while (true) {
            if (next >= 0) {
                children(next, set);
                long one = entered[0];
                long other = entered[1];
                if (one != 0 && other != 0) {
                    int near = PacketTracer.forwards(guide, 0, bvh.axis[next]) ? 0 : 1;
                    stack[top] = bvh.child[2 * next + 1 - near];
                    stackSet[top++] = near == 0 ? other : one;
                    set = near == 0 ? one : other;
                    next = bvh.child[2 * next + near];
                    continue;
                }
                if ((one | other) != 0) {
                    set = one | other;
                    next = bvh.child[2 * next + (one != 0 ? 0 : 1)];
                    continue;
                }
            } else {
                meet(~next, set);
            }
            do {
                if (top == 0) {
                    return;
                }
                next = stack[--top];
                set = stackSet[top];
                // The boxes of an inner node's children are tested anyway.
                set = next < 0 ? entering(bvh.boxes, bvh.leaf[~next], set) : set;
            } while (set == 0);
        }
    }

    /** Writes which rays of a set enter the children of a node to {@link #entered}. */
    private void children(int node, long set) {
        long one = 0;
        long other = 0;
        for (long left = set; left != 0; left = after(left, first(left))) {
            int k = first(left);
            box[k].hits(bvh.boxes, 12 * node, 2, two);
            one |= (long) two[0] << k * W;
            other |= (long) two[1] << k * W;
        }
        entered[0] = one & set;
        entered[1] = other & set;
    }

    /** The rays of a set that enter a box. */
    private long entering(float[] boxes, int at, long set) {
        long enter = 0;
        for (long left = set; left != 0; left = after(left, first(left))) {
            int k = first(left);
            enter |= box[k].hits(boxes, at) << k * W;
        }
        return enter & set;
    }

    /** Asks a primitive and lets rays that met it go no farther; a bit for each packet that has such a ray. */
    private int meet(int s, long set) {
        int nearer = nearer(s, set);
        for (int left = nearer; left != 0; left &= left - 1) {
            int k = Integer.numberOfTrailingZeros(left);
            box[k].limit(packets[k].t);
        }
        return nearer;
    }

    private int nearer(int s, long set) {
        if (primitives.mesh(s) != null) {
            return solid.mesh.nearer(packets, set, s);
        }
        int nearer = 0;
        for (long left = set; left != 0; left = after(left, first(left))) {
            int k = first(left);
            nearer |= (solid.nearer(packets[k], s, MeshGroup.of(set, k)) ? 1 : 0) << k;
        }
        return nearer;
    }

    /**
     * The rays of a set, not empty, that meet any primitive at a distance below their {@code limit}; all packets have one end.
     *
     * @param candidates of a beam that all of the rays are in, up to their limits
     */
    long blocked(long set, Candidates candidates) {
        return !candidates.tooMany ? blockedByAny(set, candidates) : all != null ? blockedByAny(set, all) : searchBlocked(set);
    }

    private long blockedByAny(long set, Candidates candidates) {
        boolean bare = candidates.count <= PacketTracer.BARE;
        if (!bare) {
            touch(set, candidates, true);
        }
        long open = set;
        for (int c = 0; c < candidates.count && open != 0; c++) {
            long asked = bare ? open : 0;
            for (long left = open; !bare && left != 0; left = after(left, first(left))) {
                int k = first(left);
                asked |= (long) masks[k][c] << k * W;
            }
            long blocked = below(candidates.primitive[c], asked & open);
            open &= ~blocked;
            if (blocked != 0) {
                candidates.promote(c);
            }
        }
        return set & ~open;
    }

    private long searchBlocked(long set) {
        for (long left = set; left != 0; left = after(left, first(left))) {
            int k = first(left);
            box[k].enter(packets[k]);
            box[k].limit(packets[k].limit);
        }
        long open = set;
        if (lastOccluder >= 0) {
            open &= ~below(lastOccluder, entering(bvh.boxes, bvh.leaf[lastOccluder], open));
        }
        int top = 0;
        stack[top] = 0;
        stackSet[top++] = open;
        while (top > 0 && open != 0) {
            int next = stack[--top];
            long asked = stackSet[top] & open;
            while (asked != 0 && next >= 0) {
                children(next, asked);
                long one = entered[0];
                long other = entered[1];
                if (one != 0 && other != 0) {
                    stack[top] = bvh.child[2 * next + 1];
                    stackSet[top++] = other;
                }
                asked = one != 0 ? one : other;
                next = bvh.child[2 * next + (one != 0 ? 0 : 1)];
            }
            if (asked != 0 && ~next != lastOccluder) {
                open &= ~below(~next, asked);
            }
        }
        return set & ~open;
    }

    private long below(int s, long set) {
        if (set == 0) {
            return 0;
        }
        long met = 0;
        if (primitives.mesh(s) != null) {
            met = solid.mesh.below(packets, set, s);
        } else {
            for (long left = set; left != 0; left = after(left, first(left))) {
                int k = first(left);
                met |= (long) solid.below(packets[k], s, MeshGroup.of(set, k)) << k * W;
            }
        }
        lastOccluder = met != 0 ? s : lastOccluder;
        return met;
    }
}
