package lightning.render.engine.lanes;

import java.util.Arrays;
import lightning.render.trace.Geometry;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.SurfaceHit;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.CandidateList;
import org.jspecify.annotations.Nullable;

/**
 * Packet tracer for single packets of rays. Holds scratch memory: use one per thread.
 *
 * <p>Packets are an optimization, not an approximation: each lane's result is that of the scalar functions of
 * {@link SolidGeometry} and {@link SurfaceHit}, bit for bit. Boxes are tested in floats and only reject; hits are decided in
 * doubles.
 *
 * <p>Directions have a length from 1e−30 to 1e30; origins are the camera or lie within the scene's bounds.
 */
public final class PacketTracer {
    /** Up to this many primitives, all boxes are tested in turn; the BVH is faster from about forty. */
    static final int MAX_LINEAR_PRIMITIVES = 32;

    /** Up to this many primitives are tested without their boxes, which cost as much as one or two primitives. */
    static final int MAX_WITHOUT_BOX_TEST = 3;

    private final PrimitiveTable primitives;
    private final Bvh bvh;
    private final BoxTestLanes boxTest = new BoxTestLanes();
    private final PrimitiveLanes primitiveLanes;
    private final SurfaceHitLanes surfaceLanes;
    private final int[] stack;
    private final int[] stackMask;
    private final int[] masks = new int[2];
    private final @Nullable CandidateList allPrimitives;
    private int lastOccluder = -1;

    public PacketTracer(Geometry geometry) {
        this(geometry.bvh(), MAX_LINEAR_PRIMITIVES);
    }

    public PacketTracer(Bvh bvh, int maxLinear) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        primitiveLanes = new PrimitiveLanes(primitives);
        surfaceLanes = new SurfaceHitLanes(primitives);
        stack = new int[bvh.depth + 1];
        stackMask = new int[bvh.depth + 1];
        allPrimitives = bvh.size() <= Math.max(maxLinear, 1) ? CandidateList.fromBvh(bvh) : null;
    }

    /** Finds the nearest hit of the first {@code laneCount} lanes; writes {@code t} and {@code primitive}. */
    public void findNearest(RayPacket p, int laneCount) {
        if (allPrimitives != null) {
            findNearest(p, laneCount, allPrimitives);
            return;
        }
        boxTest.setRays(p);
        primitiveLanes.resetHits(p);
        int top = 0;
        int next = 0;
        int mask = laneMask(laneCount);
        int lane = 0;
        while (true) {
            if (next >= 0) {
                boxTest.hits(bvh.boxes, 12 * next, 2, masks);
                int first = masks[0] & mask;
                int second = masks[1] & mask;
                if (first != 0 && second != 0) {
                    int near = isForward(p, lane, bvh.axis[next]) ? 0 : 1;
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
                intersect(p, ~next, mask);
            }
            do {
                if (top == 0) {
                    primitiveLanes.writePrimitives(p);
                    return;
                }
                next = stack[--top];
                mask = stackMask[top];
                // The boxes of an inner node's children are tested anyway.
                mask = next < 0 ? (int) boxTest.hits(bvh.boxes, bvh.leafBox[~next]) & mask : mask;
            } while (mask == 0);
        }
    }

    /**
     * Finds the nearest hit among the {@code candidates}; writes {@code t} and {@code primitive}.
     *
     * @param candidates candidates of a beam that contains all of the packet's rays
     */
    public void findNearest(RayPacket p, int laneCount, CandidateList candidates) {
        if (candidates.overflow) {
            findNearest(p, laneCount);
            return;
        }
        primitiveLanes.resetHits(p);
        int lanes = laneMask(laneCount);
        if (candidates.count <= MAX_WITHOUT_BOX_TEST) {
            for (int c = 0; c < candidates.count; c++) {
                primitiveLanes.updateNearest(p, candidates.primitive[c], lanes);
            }
        } else {
            boxTest.setRays(p);
            int[] masks = candidates.masks;
            boxTest.hits(candidates.boxes, 0, candidates.count, masks);
            boolean hasHits = false;
            for (int c = 0; c < candidates.count; c++) {
                int mask = masks[c] & lanes;
                if (mask != 0 && hasHits) {
                    mask &= (int) boxTest.hits(candidates.boxes, 6 * c);
                }
                if (mask != 0) {
                    hasHits |= intersect(p, candidates.primitive[c], mask);
                }
            }
        }
        primitiveLanes.writePrimitives(p);
    }

    /**
     * Returns which of the first {@code laneCount} lanes hit any primitive at a distance below their {@code limit}.
     *
     * @return one bit per lane, the lowest for lane 0
     */
    public int findBlocked(RayPacket p, int laneCount) {
        if (allPrimitives != null) {
            return findBlocked(p, laneCount, allPrimitives);
        }
        boxTest.setRays(p);
        boxTest.setLimits(p.limit);
        int unblocked = laneMask(laneCount);
        int lanes = unblocked;
        if (lastOccluder >= 0) {
            unblocked &= ~blockedBy(p, lastOccluder, (int) boxTest.hits(bvh.boxes, bvh.leafBox[lastOccluder]) & unblocked);
        }
        int top = 0;
        stack[top] = 0;
        stackMask[top++] = unblocked;
        while (top > 0 && unblocked != 0) {
            int next = stack[--top];
            int mask = stackMask[top] & unblocked;
            while (mask != 0 && next >= 0) {
                boxTest.hits(bvh.boxes, 12 * next, 2, masks);
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
                unblocked &= ~blockedBy(p, ~next, mask);
            }
        }
        return lanes & ~unblocked;
    }

    /**
     * Returns which of the first {@code laneCount} lanes hit any of the {@code candidates} at a distance below their
     * {@code limit}.
     *
     * @param candidates candidates of a beam that contains all of the packet's rays, up to their limits
     */
    public int findBlocked(RayPacket p, int laneCount, CandidateList candidates) {
        if (candidates.overflow) {
            return findBlocked(p, laneCount);
        }
        int lanes = laneMask(laneCount);
        int unblocked = lanes;
        int[] masks = candidates.masks;
        if (candidates.count <= MAX_WITHOUT_BOX_TEST) {
            Arrays.fill(masks, 0, candidates.count, lanes);
        } else {
            boxTest.setRays(p);
            boxTest.setLimits(p.limit);
            boxTest.hits(candidates.boxes, 0, candidates.count, masks);
        }
        for (int c = 0; c < candidates.count && unblocked != 0; c++) {
            int blocked = blockedBy(p, candidates.primitive[c], masks[c] & unblocked);
            unblocked &= ~blocked;
            if (blocked != 0) {
                candidates.moveToFront(c);
            }
        }
        return lanes & ~unblocked;
    }

    private int blockedBy(RayPacket p, int s, int mask) {
        if (mask == 0) {
            return 0;
        }
        int blocked = primitiveLanes.findBlocked(p, s, mask);
        lastOccluder = blocked != 0 ? s : lastOccluder;
        return blocked;
    }

    private boolean intersect(RayPacket p, int s, int mask) {
        boolean nearer = primitiveLanes.updateNearest(p, s, mask);
        if (nearer) {
            boxTest.setLimits(p.t);
        }
        return nearer;
    }

    private static int laneMask(int laneCount) {
        return -1 >>> -laneCount;
    }

    static boolean isForward(RayPacket p, int lane, int axis) {
        return (axis == 0 ? p.dx : axis == 1 ? p.dy : p.dz)[lane] > 0;
    }

    /** Writes {@code t} for lanes whose {@code primitive} is already known. */
    public void writeDistances(RayPacket p, int laneCount) {
        int left = 0;
        for (int i = 0; i < laneCount; i++) {
            p.t[i] = SolidGeometry.MISS;
            left |= p.primitive[i] >= 0 ? 1 << i : 0;
        }
        while (left != 0) {
            int s = p.primitive[Integer.numberOfTrailingZeros(left)];
            left &= ~primitiveLanes.writeDistances(p, s, left);
        }
    }

    /** Computes the surfaces for those of the first {@code laneCount} lanes that hit a primitive. */
    public void writeSurfaces(RayPacket p, int laneCount, SurfacePacket out) {
        surfaceLanes.compute(p, laneCount, out);
    }

    /** Computes only their points in local coordinates of the primitive. */
    public void writeLocalPoints(RayPacket p, int laneCount, SurfacePacket out) {
        surfaceLanes.computeLocalPoints(p, laneCount, out);
    }
}
