package lightning.render.engine.lanes;

import lightning.render.trace.Geometry;
import lightning.render.trace.mesh.MeshPacketTraversal;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.CandidateList;
import org.jspecify.annotations.Nullable;

/**
 * Tracer of packets in groups, for scenes with meshes. The packets of a group traverse the BVH as in {@link PacketTracer}, each
 * tested against each box, but intersect a mesh together. Sets of rays are bits of a {@code long}, as in
 * {@link MeshGroupTracer}. Holds scratch memory: use one per thread.
 */
final class PacketGroupTracer {
    /** Maximum number of packets of a group. */
    static final int MAX_PACKETS = MeshPacketTraversal.PACKETS;

    private static final int W = RayPacket.WIDTH;

    /** Packets, filled by the caller, from the first up to the last in the set. */
    final RayPacket[] packets = new RayPacket[MAX_PACKETS];
    private final PrimitiveTable primitives;
    private final Bvh bvh;
    private final BoxTestLanes[] boxTest = new BoxTestLanes[MAX_PACKETS];
    private final PrimitiveLanes primitiveLanes;
    private final int[] stack;
    private final long[] stackSet;
    private final int[] childMasks = new int[2];
    /** Rays that enter the two children of a node. */
    private final long[] entered = new long[2];
    private final int[][] masks = new int[MAX_PACKETS][0];
    private final @Nullable CandidateList allPrimitives;
    private int lastOccluder = -1;

    PacketGroupTracer(Geometry geometry) {
        this(geometry.bvh(), PacketTracer.MAX_LINEAR_PRIMITIVES);
    }

    PacketGroupTracer(Bvh bvh, int maxLinear) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        primitiveLanes = new PrimitiveLanes(primitives);
        stack = new int[bvh.depth + 1];
        stackSet = new long[bvh.depth + 1];
        allPrimitives = bvh.size() <= Math.max(maxLinear, 1) ? CandidateList.fromBvh(bvh) : null;
        for (int k = 0; k < MAX_PACKETS; k++) {
            packets[k] = new RayPacket();
            boxTest[k] = new BoxTestLanes();
        }
    }

    /** Returns the first packet of a set. */
    private static int firstPacket(long set) {
        return Long.numberOfTrailingZeros(set) / W;
    }

    /** Returns the set without packets up to {@code k}. */
    private static long packetsAfter(long set, int k) {
        return k + 1 == MAX_PACKETS ? 0 : set & -1L << (k + 1) * W;
    }

    /**
     * Finds the nearest hits of a non-empty set of rays; writes {@code t}, {@code primitive} and {@code part}.
     *
     * @param candidates candidates of a beam that contains all of the rays
     */
    void findNearest(long set, CandidateList candidates) {
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            primitiveLanes.resetHits(packets[firstPacket(left)]);
        }
        if (!candidates.overflow) {
            nearestCandidate(set, candidates);
        } else if (allPrimitives != null) {
            nearestCandidate(set, allPrimitives);
        } else {
            traverse(set);
        }
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            primitiveLanes.writePrimitives(packets[firstPacket(left)]);
        }
    }

    private void nearestCandidate(long set, CandidateList candidates) {
        if (candidates.count <= PacketTracer.MAX_WITHOUT_BOX_TEST) {
            for (int c = 0; c < candidates.count; c++) {
                updateNearest(candidates.primitive[c], set);
            }
            return;
        }
        testBoxes(set, candidates, false);
        int hitPackets = 0;
        for (int c = 0; c < candidates.count; c++) {
            long queried = 0;
            for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
                int k = firstPacket(left);
                int mask = masks[k][c] & MeshGroupTracer.packetMask(set, k);
                if (mask != 0 && (hitPackets >>> k & 1) != 0) {
                    mask &= (int) boxTest[k].hits(candidates.boxes, 6 * c);
                }
                queried |= (long) mask << k * W;
            }
            if (queried != 0) {
                hitPackets |= intersect(candidates.primitive[c], queried);
            }
        }
    }

    /** Tests the boxes of all candidates. */
    private void testBoxes(long set, CandidateList candidates, boolean withLimits) {
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            int k = firstPacket(left);
            if (masks[k].length < candidates.count) {
                masks[k] = new int[candidates.primitive.length];
            }
            boxTest[k].setRays(packets[k]);
            if (withLimits) {
                boxTest[k].setLimits(packets[k].limit);
            }
            boxTest[k].hits(candidates.boxes, 0, candidates.count, masks[k]);
        }
    }

    private void traverse(long initialSet) {
        for (long left = initialSet; left != 0; left = packetsAfter(left, firstPacket(left))) {
            boxTest[firstPacket(left)].setRays(packets[firstPacket(left)]);
        }
        int top = 0;
        int next = 0;
        long set = initialSet;
        RayPacket guide = packets[firstPacket(initialSet)];
        while (true) {
            if (next >= 0) {
                testChildren(next, set);
                long firstSet = entered[0];
                long secondSet = entered[1];
                if (firstSet != 0 && secondSet != 0) {
                    int near = PacketTracer.isForward(guide, 0, bvh.axis[next]) ? 0 : 1;
                    stack[top] = bvh.child[2 * next + 1 - near];
                    stackSet[top++] = near == 0 ? secondSet : firstSet;
                    set = near == 0 ? firstSet : secondSet;
                    next = bvh.child[2 * next + near];
                    continue;
                }
                if ((firstSet | secondSet) != 0) {
                    set = firstSet | secondSet;
                    next = bvh.child[2 * next + (firstSet != 0 ? 0 : 1)];
                    continue;
                }
            } else {
                intersect(~next, set);
            }
            do {
                if (top == 0) {
                    return;
                }
                next = stack[--top];
                set = stackSet[top];
                // The boxes of an inner node's children are tested anyway.
                set = next < 0 ? enteringRays(bvh.boxes, bvh.leafBox[~next], set) : set;
            } while (set == 0);
        }
    }

    /** Writes the rays of a set that enter the children of a node to {@link #entered}. */
    private void testChildren(int node, long set) {
        long firstSet = 0;
        long secondSet = 0;
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            int k = firstPacket(left);
            boxTest[k].hits(bvh.boxes, 12 * node, 2, childMasks);
            firstSet |= (long) childMasks[0] << k * W;
            secondSet |= (long) childMasks[1] << k * W;
        }
        entered[0] = firstSet & set;
        entered[1] = secondSet & set;
    }

    /** Returns the rays of a set that enter a box. */
    private long enteringRays(float[] boxes, int at, long set) {
        long result = 0;
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            int k = firstPacket(left);
            result |= boxTest[k].hits(boxes, at) << k * W;
        }
        return result & set;
    }

    /** Intersects a primitive and shortens the limits of rays that hit it; returns one bit per packet that has such a ray. */
    private int intersect(int s, long set) {
        int nearer = updateNearest(s, set);
        for (int left = nearer; left != 0; left &= left - 1) {
            int k = Integer.numberOfTrailingZeros(left);
            boxTest[k].setLimits(packets[k].t);
        }
        return nearer;
    }

    private int updateNearest(int s, long set) {
        if (primitives.mesh(s) != null) {
            return primitiveLanes.mesh.updateNearest(packets, set, s);
        }
        int nearer = 0;
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            int k = firstPacket(left);
            nearer |= (primitiveLanes.updateNearest(packets[k], s, MeshGroupTracer.packetMask(set, k)) ? 1 : 0) << k;
        }
        return nearer;
    }

    /**
     * Returns the rays of a non-empty set that hit any primitive at a distance below their {@code limit}; all packets have the
     * same target.
     *
     * @param candidates candidates of a beam that contains all of the rays, up to their limits
     */
    long findBlocked(long set, CandidateList candidates) {
        return !candidates.overflow ? blockedByCandidates(set, candidates) : allPrimitives != null ? blockedByCandidates(set, allPrimitives)
                : traverseBlocked(set);
    }

    private long blockedByCandidates(long set, CandidateList candidates) {
        boolean withoutBoxTest = candidates.count <= PacketTracer.MAX_WITHOUT_BOX_TEST;
        if (!withoutBoxTest) {
            testBoxes(set, candidates, true);
        }
        long unblocked = set;
        for (int c = 0; c < candidates.count && unblocked != 0; c++) {
            long queried = withoutBoxTest ? unblocked : 0;
            for (long left = unblocked; !withoutBoxTest && left != 0; left = packetsAfter(left, firstPacket(left))) {
                int k = firstPacket(left);
                queried |= (long) masks[k][c] << k * W;
            }
            long blocked = blockedBy(candidates.primitive[c], queried & unblocked);
            unblocked &= ~blocked;
            if (blocked != 0) {
                candidates.moveToFront(c);
            }
        }
        return set & ~unblocked;
    }

    private long traverseBlocked(long set) {
        for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
            int k = firstPacket(left);
            boxTest[k].setRays(packets[k]);
            boxTest[k].setLimits(packets[k].limit);
        }
        long unblocked = set;
        if (lastOccluder >= 0) {
            unblocked &= ~blockedBy(lastOccluder, enteringRays(bvh.boxes, bvh.leafBox[lastOccluder], unblocked));
        }
        int top = 0;
        stack[top] = 0;
        stackSet[top++] = unblocked;
        while (top > 0 && unblocked != 0) {
            int next = stack[--top];
            long queried = stackSet[top] & unblocked;
            while (queried != 0 && next >= 0) {
                testChildren(next, queried);
                long firstSet = entered[0];
                long secondSet = entered[1];
                if (firstSet != 0 && secondSet != 0) {
                    stack[top] = bvh.child[2 * next + 1];
                    stackSet[top++] = secondSet;
                }
                queried = firstSet != 0 ? firstSet : secondSet;
                next = bvh.child[2 * next + (firstSet != 0 ? 0 : 1)];
            }
            if (queried != 0 && ~next != lastOccluder) {
                unblocked &= ~blockedBy(~next, queried);
            }
        }
        return set & ~unblocked;
    }

    private long blockedBy(int s, long set) {
        if (set == 0) {
            return 0;
        }
        long blocked = 0;
        if (primitives.mesh(s) != null) {
            blocked = primitiveLanes.mesh.findBlocked(packets, set, s);
        } else {
            for (long left = set; left != 0; left = packetsAfter(left, firstPacket(left))) {
                int k = firstPacket(left);
                blocked |= (long) primitiveLanes.findBlocked(packets[k], s, MeshGroupTracer.packetMask(set, k)) << k * W;
            }
        }
        lastOccluder = blocked != 0 ? s : lastOccluder;
        return blocked;
    }
}
