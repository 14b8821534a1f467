package lightning.render.trace.tree;

import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidGeometry;
import lightning.render.trace.solid.SurfaceContact;

/** Single-ray traversal of the BVH or of a candidate list. Holds scratch memory: use one per thread. */
public final class RayTraversal {
    /** Up to this many candidates are tested without their boxes. */
    private static final int MAX_WITHOUT_BOX_TEST = 2;

    private final Bvh bvh;
    private final PrimitiveTable primitives;
    private final BoxRay boxRay = new BoxRay();
    private final MeshRayQuery probe = new MeshRayQuery();
    private final int[] stack;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private ShadowRayTarget target = ShadowRayTarget.OFF_SURFACE;
    private double nearestDistance;
    private int nearestPrimitive;
    private int part;
    private int lastOccluder = -1;

    public RayTraversal(Bvh bvh) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        stack = new int[bvh.depth + 2];
    }

    /** Sets a ray; its origin must be the camera or lie within the scene's bounds. */
    public void setRay(double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        boxRay.setRay(ox, oy, oz, dx, dy, dz);
    }

    /** Sets the target at which the next rays end, at distance 1. */
    public void setTarget(ShadowRayTarget newTarget) {
        target = newTarget;
    }

    /** Returns the primitive that the ray hits first, the one with the lowest index among equal distances, or −1. */
    int nearest() {
        return nearest(SolidGeometry.MISS);
    }

    /** Returns the primitive that the ray hits first at a distance below {@code limit}, or −1. */
    int nearest(double limit) {
        nearestDistance = limit;
        nearestPrimitive = -1;
        int top = 0;
        int next = root();
        boolean more = bvh.size() > 0;
        while (more) {
            if (next < 0) {
                testPrimitive(~next);
            } else {
                boolean first = boxRay.hits(bvh.boxes, 12 * next, nearestDistance);
                boolean second = boxRay.hits(bvh.boxes, 12 * next + 6, nearestDistance);
                int near = boxRay.isForward(bvh.axis[next]) ? 0 : 1;
                if (first && second) {
                    stack[top++] = bvh.child[2 * next + 1 - near];
                    next = bvh.child[2 * next + near];
                    continue;
                }
                if (first || second) {
                    next = bvh.child[2 * next + (first ? 0 : 1)];
                    continue;
                }
            }
            more = top > 0;
            next = more ? stack[--top] : 0;
        }
        return nearestPrimitive;
    }

    /** Returns the primitive that the ray hits first; tests every primitive. */
    public int nearestBruteForce() {
        nearestDistance = SolidGeometry.MISS;
        nearestPrimitive = -1;
        for (int i = 0; i < bvh.size(); i++) {
            testPrimitive(bvh.member(i));
        }
        return nearestPrimitive;
    }

    /** Returns primitive {@code s} if the ray hits it, otherwise −1. */
    public int intersectPrimitive(int s) {
        nearestDistance = SolidGeometry.MISS;
        nearestPrimitive = -1;
        testPrimitive(s);
        return nearestPrimitive;
    }

    /** Returns the candidate that the ray hits first, or −1. */
    public int nearest(CandidateList candidates) {
        if (candidates.overflow) {
            return nearest();
        }
        nearestDistance = SolidGeometry.MISS;
        nearestPrimitive = -1;
        for (int c = 0; c < candidates.count; c++) {
            if (candidates.count <= MAX_WITHOUT_BOX_TEST || boxRay.hits(candidates.boxes, 6 * c, nearestDistance)) {
                testPrimitive(candidates.primitive[c]);
            }
        }
        return nearestPrimitive;
    }

    /** Returns the distance of the hit found by {@link #nearest}, or {@code +∞}. */
    public double distance() {
        return nearestDistance;
    }

    /** Returns the part of the primitive that was hit. */
    public int part() {
        return part;
    }

    private void testPrimitive(int s) {
        boolean mesh = primitives.mesh(s) != null;
        double t = mesh ? meshDistance(s) : distance(s);
        if (t < nearestDistance || t == nearestDistance && s < nearestPrimitive) {
            nearestDistance = t;
            nearestPrimitive = s;
            part = mesh ? probe.triangle() : 0;
        }
    }

    /** Returns the distance to mesh {@code s} if it is not beyond the nearest hit so far. */
    private double meshDistance(int s) {
        setMeshRay(s);
        return probe.nearest(nearestDistance);
    }

    /** Returns whether the ray hits any primitive at a distance below {@code limit}. */
    public boolean isBlocked(double limit) {
        if (lastOccluder >= 0 && boxRay.hits(bvh.boxes, bvh.leafBox[lastOccluder], limit) && isBlockedBy(lastOccluder, limit)) {
            return true;
        }
        int top = 0;
        if (bvh.size() > 0) {
            stack[top++] = root();
        }
        while (top > 0) {
            int next = stack[--top];
            if (next < 0) {
                if (isBlockedBy(~next, limit)) {
                    lastOccluder = ~next;
                    return true;
                }
                continue;
            }
            for (int c = 0; c < 2; c++) {
                if (boxRay.hits(bvh.boxes, 12 * next + 6 * c, limit)) {
                    stack[top++] = bvh.child[2 * next + c];
                }
            }
        }
        return false;
    }

    /** Returns whether the ray hits any candidate at a distance below {@code limit}; moves that candidate to the front. */
    public boolean isBlocked(double limit, CandidateList candidates) {
        if (candidates.overflow) {
            return isBlocked(limit);
        }
        for (int c = 0; c < candidates.count; c++) {
            if ((candidates.count <= MAX_WITHOUT_BOX_TEST || boxRay.hits(candidates.boxes, 6 * c, limit))
                    && isBlockedBy(candidates.primitive[c], limit)) {
                candidates.moveToFront(c);
                return true;
            }
        }
        return false;
    }

    private boolean isBlockedBy(int s, double limit) {
        if (primitives.mesh(s) != null) {
            setMeshRay(s);
            return probe.isBlocked(limit);
        }
        return distance(s) < limit;
    }

    private double distance(int s) {
        return endsOn(s) ? primitives.distance(s, ox, oy, oz, dx, dy, dz, SurfaceContact.END)
                : primitives.distance(s, ox, oy, oz, dx, dy, dz);
    }

    private void setMeshRay(int s) {
        primitives.setProbeRay(probe, s, ox, oy, oz, dx, dy, dz, endsOn(s));
    }

    private boolean endsOn(int s) {
        int index = target.indexOf(s);
        return index >= 0 && target.touches(index, ox, oy, oz);
    }

    private int root() {
        return primitives.count == 1 ? ~0 : 0;
    }
}
