package lightning.render.trace.tree;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * The few primitives that a bundle of rays can meet, nearest first, each with its box: found once for the
 * bundle, so that its packets need not search the tree. Reused; not shared between threads.
 */
public final class Candidates {
    /** With more than this the tree is faster. */
    static final int MOST = 48;

    public int count;
    /** Whether there are more than fit: packets must search the tree. */
    public boolean tooMany;
    public int[] primitive = new int[MOST];
    /** The primitives' boxes, {@code float[6 * count]}. */
    public float[] boxes = new float[6 * MOST];
    /** Scratch of the tracer: which lanes of a packet may meet each. */
    public int[] masks = new int[MOST];
    private final double[] since = new double[MOST];
    private int[] stack = new int[16];

    /** All primitives of a small scene. */
    public static Candidates all(Bvh bvh) {
        Candidates c = new Candidates();
        c.count = bvh.primitives.count;
        c.primitive = new int[c.count];
        Arrays.setAll(c.primitive, s -> s);
        c.boxes = new float[6 * c.count];
        for (int s = 0; s < c.count; s++) {
            System.arraycopy(bvh.boxes, bvh.leaf[s], c.boxes, 6 * s, 6);
        }
        c.masks = new int[c.count];
        return c;
    }

    /** All primitives of a tree that has not all of a scene's. */
    public static Candidates all(Bvh bvh, boolean[] kept) {
        Candidates c = new Candidates();
        c.primitive = IntStream.range(0, kept.length).filter(s -> kept[s]).toArray();
        c.count = c.primitive.length;
        c.boxes = new float[6 * c.count];
        for (int i = 0; i < c.count; i++) {
            System.arraycopy(bvh.boxes, bvh.leaf[c.primitive[i]], c.boxes, 6 * i, 6);
        }
        c.masks = new int[c.count];
        return c;
    }

    /** Whether no ray of the bundle meets anything: nothing blocks it. */
    public boolean isEmpty() {
        return count == 0 && !tooMany;
    }

    /** Finds the primitives whose boxes the beam touches. */
    public void collect(Bvh bvh, Beam beam) {
        count = 0;
        tooMany = false;
        if (stack.length < bvh.depth + 2) {
            stack = new int[bvh.depth + 2];
        }
        int top = 0;
        if (bvh.primitives.count == 1) {
            add(bvh, 0, beam.touches(bvh.boxes, bvh.leaf[0]));
        } else if (bvh.primitives.count > 1) {
            stack[top++] = 0;
        }
        while (top > 0) {
            int node = stack[--top];
            for (int c = 0; c < 2; c++) {
                double time = beam.touches(bvh.boxes, 12 * node + 6 * c);
                int child = bvh.child[2 * node + c];
                if (child < 0) {
                    add(bvh, ~child, time);
                    if (tooMany) {
                        return;
                    }
                } else if (time < Double.POSITIVE_INFINITY) {
                    stack[top++] = child;
                }
            }
        }
    }

    /** Puts a primitive before those that the beam touches later. */
    private void add(Bvh bvh, int s, double time) {
        if (!(time < Double.POSITIVE_INFINITY)) {
            return;
        }
        if (count == MOST) {
            tooMany = true;
            return;
        }
        int at = count++;
        for (; at > 0 && since[at - 1] > time; at--) {
            since[at] = since[at - 1];
            primitive[at] = primitive[at - 1];
            System.arraycopy(boxes, 6 * at - 6, boxes, 6 * at, 6);
        }
        since[at] = time;
        primitive[at] = s;
        System.arraycopy(bvh.boxes, bvh.leaf[s], boxes, 6 * at, 6);
    }

    /** Leaves out the primitives of all materials but one; does nothing where there are too many. */
    public void keepMaterial(PrimitiveTable primitives, int material) {
        keep(s -> primitives.material[s] == material);
    }

    private void keep(IntPredicate which) {
        int kept = 0;
        for (int c = 0; c < count; c++) {
            if (which.test(primitive[c])) {
                take(this, c, kept++);
            }
        }
        count = kept;
    }

    /** Leaves out the primitives that ways leave behind; does nothing where there are too many. */
    public void leaveOut(PrimitiveTable primitives, Departure ways) {
        keep(s -> !ways.leaves(primitives, s));
    }

    /** Takes those of others, which are not too many, that a beam within theirs touches and ways in it do not leave behind. */
    public void takeFrom(Candidates others, PrimitiveTable primitives, Beam beam, Departure ways) {
        count = 0;
        tooMany = false;
        for (int c = 0; c < others.count; c++) {
            if (beam.touches(others.boxes, 6 * c) < Double.POSITIVE_INFINITY && !ways.leaves(primitives, others.primitive[c])) {
                take(others, c, count++);
            }
        }
    }

    private void take(Candidates others, int c, int at) {
        since[at] = others.since[c];
        primitive[at] = others.primitive[c];
        System.arraycopy(others.boxes, 6 * c, boxes, 6 * at, 6);
    }

    /** Moves a primitive that blocks rays to the front: the next packet is likely to be blocked by it too. */
    public void promote(int c) {
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
