package lightning.render.trace.tree;

import lightning.render.trace.mesh.MeshProbe;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.Form;
import lightning.render.trace.solid.Touch;

/** Searches what one ray after the other meets, by the tree of boxes or among candidates. Scratch memory: one for each thread. */
public final class RayWalk {
    /** Up to this many candidates are tested without their boxes. */
    private static final int BARE = 2;

    private final Bvh bvh;
    private final PrimitiveTable primitives;
    private final BoxRay box = new BoxRay();
    private final MeshProbe probe = new MeshProbe();
    private final int[] stack;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private WayEnd end = WayEnd.OPEN;
    private double best;
    private int found;
    private int part;
    private int lastOccluder = -1;

    public RayWalk(Bvh bvh) {
        this.bvh = bvh;
        primitives = bvh.primitives;
        stack = new int[bvh.depth + 2];
    }

    /** Takes a ray; its origin is the camera or lies within the box of the scene. */
    public void enter(double originX, double originY, double originZ, double directionX, double directionY, double directionZ) {
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        box.enter(ox, oy, oz, dx, dy, dz);
    }

    /** Says where the rays end that are asked for from now on: at distance 1, if at all. */
    public void leadTo(WayEnd wayEnd) {
        end = wayEnd;
    }

    /** The primitive that the ray meets first, the one with the lowest index among equals, or −1. */
    int nearest() {
        return nearest(Form.MISS);
    }

    /** The same of those at a distance below {@code limit}. */
    int nearest(double limit) {
        best = limit;
        found = -1;
        int top = 0;
        int next = root();
        boolean more = primitives.count > 0;
        while (more) {
            if (next < 0) {
                meet(~next);
            } else {
                boolean first = box.hits(bvh.boxes, 12 * next, best);
                boolean second = box.hits(bvh.boxes, 12 * next + 6, best);
                int near = box.forwards(bvh.axis[next]) ? 0 : 1;
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
        return found;
    }

    /** The same by asking every primitive. */
    public int nearestInTurn() {
        best = Form.MISS;
        found = -1;
        for (int s = 0; s < primitives.count; s++) {
            meet(s);
        }
        return found;
    }

    /** The same where only primitive {@code s} can be met. */
    public int only(int s) {
        best = Form.MISS;
        found = -1;
        meet(s);
        return found;
    }

    /** The same where only the candidates can be met. */
    public int nearest(Candidates candidates) {
        if (candidates.tooMany) {
            return nearest();
        }
        best = Form.MISS;
        found = -1;
        for (int c = 0; c < candidates.count; c++) {
            if (candidates.count <= BARE || box.hits(candidates.boxes, 6 * c, best)) {
                meet(candidates.primitive[c]);
            }
        }
        return found;
    }

    /** The distance of what {@link #nearest} found, or {@code +∞}. */
    public double distance() {
        return best;
    }

    /** The part of it that was met. */
    public int part() {
        return part;
    }

    private void meet(int s) {
        boolean mesh = primitives.mesh(s) != null;
        double t = mesh ? meshDistance(s) : distance(s);
        if (t < best || t == best && s < found) {
            best = t;
            found = s;
            part = mesh ? probe.triangle() : 0;
        }
    }

    /** The distance to mesh {@code s} where it is no farther than what was found. */
    private double meshDistance(int s) {
        enterMesh(s);
        return probe.nearest(best);
    }

    /** Whether the way meets any primitive at a distance below {@code limit}. */
    public boolean blocked(double limit) {
        if (lastOccluder >= 0 && box.hits(bvh.boxes, bvh.leaf[lastOccluder], limit) && isMet(lastOccluder, limit)) {
            return true;
        }
        int top = 0;
        if (primitives.count > 0) {
            stack[top++] = root();
        }
        while (top > 0) {
            int next = stack[--top];
            if (next < 0) {
                if (isMet(~next, limit)) {
                    lastOccluder = ~next;
                    return true;
                }
                continue;
            }
            for (int c = 0; c < 2; c++) {
                if (box.hits(bvh.boxes, 12 * next + 6 * c, limit)) {
                    stack[top++] = bvh.child[2 * next + c];
                }
            }
        }
        return false;
    }

    /** The same where only the candidates can be met; one that is goes to their front. */
    public boolean blocked(double limit, Candidates candidates) {
        if (candidates.tooMany) {
            return blocked(limit);
        }
        for (int c = 0; c < candidates.count; c++) {
            if ((candidates.count <= BARE || box.hits(candidates.boxes, 6 * c, limit)) && isMet(candidates.primitive[c], limit)) {
                candidates.promote(c);
                return true;
            }
        }
        return false;
    }

    private boolean isMet(int s, double limit) {
        if (primitives.mesh(s) != null) {
            enterMesh(s);
            return probe.blocked(limit);
        }
        return distance(s) < limit;
    }

    private double distance(int s) {
        return endsOn(s) ? primitives.distance(s, ox, oy, oz, dx, dy, dz, Touch.END) : primitives.distance(s, ox, oy, oz, dx, dy, dz);
    }

    private void enterMesh(int s) {
        primitives.enter(probe, s, ox, oy, oz, dx, dy, dz, endsOn(s));
    }

    private boolean endsOn(int s) {
        int index = end.indexOf(s);
        return index >= 0 && end.touches(index, ox, oy, oz);
    }

    private int root() {
        return primitives.count == 1 ? ~0 : 0;
    }
}
