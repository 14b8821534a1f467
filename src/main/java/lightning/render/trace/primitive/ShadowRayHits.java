package lightning.render.trace.primitive;

import java.util.Arrays;

/**
 * Where ways meet primitives, for each way the nearest place first; of equal ones the lowest primitive, then its lowest part. Places of a way
 * are a chain, in whatever order they are found. Reused.
 *
 * <pre>{@code
 * for (int i = crossings.first(way); i != ShadowRayHits.END; i = crossings.next(i)) {
 *     double t = crossings.t[i];
 * }
 * }</pre>
 */
public final class ShadowRayHits {
    /** The end of a chain. */
    public static final int END = -1;

    public int[] primitive = new int[8];
    public int[] part = new int[8];
    public double[] t = new double[8];
    private final int[] first;
    private int[] next = new int[8];
    private int count;
    private int currentRay;

    /** @param rayCount how many there are */
    public ShadowRayHits(int rayCount) {
        first = new int[rayCount];
        clear();
    }

    /** Forgets all. */
    public void clear() {
        Arrays.fill(first, END);
        count = 0;
    }

    /** Says whose places are added from now on. */
    public void selectRay(int ray) {
        currentRay = ray;
    }

    /** The nearest place of a way. */
    public int first(int ray) {
        return first[ray];
    }

    /** The place behind another. */
    public int next(int i) {
        return next[i];
    }

    /** Adds a place, unless it lies at the limit or beyond, or in a hole; {@code cutoutTest} is null where there are none. */
    public void add(int s, int partIndex, double distance, double limit, CutoutTest cutoutTest) {
        if (!(distance < limit) || distance == Double.POSITIVE_INFINITY || cutoutTest != null && cutoutTest.passes(partIndex, distance)) {
            return;
        }
        if (count == t.length) {
            primitive = Arrays.copyOf(primitive, 2 * count);
            part = Arrays.copyOf(part, 2 * count);
            t = Arrays.copyOf(t, 2 * count);
            next = Arrays.copyOf(next, 2 * count);
        }
        int previous = END;
        int following = first[currentRay];
        while (following != END && !isAfter(following, s, partIndex, distance)) {
            previous = following;
            following = next[following];
        }
        int at = count++;
        primitive[at] = s;
        part[at] = partIndex;
        t[at] = distance;
        next[at] = following;
        if (previous == END) {
            first[currentRay] = at;
        } else {
            next[previous] = at;
        }
    }

    private boolean isAfter(int i, int s, int partIndex, double distance) {
        return t[i] != distance ? t[i] > distance : primitive[i] != s ? primitive[i] > s : part[i] > partIndex;
    }
}
