package lightning.render.trace.tree;

import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * Primitives that a beam of rays can hit, nearest first, with their boxes. Collected once per beam so that its packets need not
 * traverse the BVH. Reused; not thread-safe.
 */
public final class CandidateList {
    /** Capacity; with more candidates the BVH is faster. */
    static final int MAX_COUNT = 48;

    public int count;
    /** True if there are more candidates than fit: packets must traverse the BVH. */
    public boolean overflow;
    public int[] primitive = new int[MAX_COUNT];
    /** Boxes of the candidates, {@code float[6 * count]}. */
    public float[] boxes = new float[6 * MAX_COUNT];
    /** Scratch memory of the tracer: lanes of a packet that may hit each candidate. */
    public int[] masks = new int[MAX_COUNT];
    private final double[] entryTime = new double[MAX_COUNT];
    private int[] stack = new int[16];

    /** Returns all primitives of a small scene. */
    public static CandidateList fromBvh(Bvh bvh) {
        return of(bvh, IntStream.range(0, bvh.size()).map(bvh::member).toArray());
    }

    /** Returns the selected primitives of a small scene, whose BVH contains only these. */
    public static CandidateList fromBvh(Bvh bvh, boolean[] selected) {
        return of(bvh, IntStream.range(0, selected.length).filter(s -> selected[s]).toArray());
    }

    private static CandidateList of(Bvh bvh, int[] primitives) {
        CandidateList c = new CandidateList();
        c.primitive = primitives;
        c.count = primitives.length;
        c.boxes = new float[6 * c.count];
        for (int i = 0; i < c.count; i++) {
            System.arraycopy(bvh.boxes, bvh.leafBox[c.primitive[i]], c.boxes, 6 * i, 6);
        }
        c.masks = new int[c.count];
        return c;
    }

    /** Returns whether no ray of the beam can hit a primitive. */
    public boolean isEmpty() {
        return count == 0 && !overflow;
    }

    /** Collects the primitives whose boxes the beam touches. */
    public void collect(Bvh bvh, RayBeam beam) {
        count = 0;
        overflow = false;
        if (stack.length < bvh.depth + 2) {
            stack = new int[bvh.depth + 2];
        }
        int top = 0;
        if (bvh.size() == 1 && bvh.primitives.count == 1) {
            add(bvh, 0, beam.entryTime(bvh.boxes, bvh.leafBox[0]));
        } else if (bvh.size() > 0) {
            stack[top++] = 0;
        }
        while (top > 0) {
            int node = stack[--top];
            for (int c = 0; c < 2; c++) {
                double time = beam.entryTime(bvh.boxes, 12 * node + 6 * c);
                int child = bvh.child[2 * node + c];
                if (child < 0) {
                    add(bvh, ~child, time);
                    if (overflow) {
                        return;
                    }
                } else if (time < Double.POSITIVE_INFINITY) {
                    stack[top++] = child;
                }
            }
        }
    }

    /** Inserts a primitive, sorted by the time when the beam enters it. */
    private void add(Bvh bvh, int s, double time) {
        if (!(time < Double.POSITIVE_INFINITY)) {
            return;
        }
        if (count == MAX_COUNT) {
            overflow = true;
            return;
        }
        int at = count++;
        for (; at > 0 && entryTime[at - 1] > time; at--) {
            entryTime[at] = entryTime[at - 1];
            primitive[at] = primitive[at - 1];
            System.arraycopy(boxes, 6 * at - 6, boxes, 6 * at, 6);
        }
        entryTime[at] = time;
        primitive[at] = s;
        System.arraycopy(bvh.boxes, bvh.leafBox[s], boxes, 6 * at, 6);
    }

    /** Removes the primitives of all materials except one; does nothing on overflow. */
    public void retainMaterial(PrimitiveTable primitives, int material) {
        retain(s -> primitives.material[s] == material);
    }

    private void retain(IntPredicate filter) {
        int retained = 0;
        for (int c = 0; c < count; c++) {
            if (filter.test(primitive[c])) {
                copyEntry(this, c, retained++);
            }
        }
        count = retained;
    }

    /** Removes the primitives that horizon culling proves to be missed; does nothing on overflow. */
    public void cull(PrimitiveTable primitives, HorizonCulling culling) {
        retain(s -> !culling.isCulled(primitives, s));
    }

    /** Copies the candidates of an enclosing beam, without overflow, that this beam touches and horizon culling keeps. */
    public void collectFrom(CandidateList source, PrimitiveTable primitives, RayBeam beam, HorizonCulling culling) {
        count = 0;
        overflow = false;
        for (int c = 0; c < source.count; c++) {
            if (beam.entryTime(source.boxes, 6 * c) < Double.POSITIVE_INFINITY && !culling.isCulled(primitives, source.primitive[c])) {
                copyEntry(source, c, count++);
            }
        }
    }

    private void copyEntry(CandidateList source, int c, int at) {
        entryTime[at] = source.entryTime[c];
        primitive[at] = source.primitive[c];
        System.arraycopy(source.boxes, 6 * c, boxes, 6 * at, 6);
    }

    /** Moves a primitive that blocks rays to the front, since it will probably block the next packet too. */
    public void moveToFront(int c) {
        for (int i = 6 * c - 1; i >= 0; i--) {
            float b = boxes[i + 6];
            boxes[i + 6] = boxes[i];
            boxes[i] = b;
        }
        int s = primitive[c];
        System.arraycopy(primitive, 0, primitive, 1, c);
        primitive[0] = s;
    }
}
