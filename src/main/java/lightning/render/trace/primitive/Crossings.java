package lightning.render.trace.primitive;

import java.util.Arrays;

/**
 * Where ways meet primitives, for each way the nearest place first; of equal ones the lowest primitive, then its lowest part. Places of a way
 * are a chain, in whatever order they are found. Reused.
 *
 * <pre>{@code
 * for (int i = crossings.first(way); i != Crossings.NONE; i = crossings.next(i)) {
 *     double t = crossings.t[i];
 * }
 * }</pre>
 */
public final class Crossings {
    /** The end of a chain. */
    public static final int NONE = -1;

    public int[] primitive = new int[8];
    public int[] part = new int[8];
    public double[] t = new double[8];
    private final int[] first;
    private int[] next = new int[8];
    private int count;
    private int way;

    /** @param ways how many there are */
    public Crossings(int ways) {
        first = new int[ways];
        clear();
    }

    /** Forgets all. */
    public void clear() {
        Arrays.fill(first, NONE);
        count = 0;
    }

    /** Says whose places are added from now on. */
    public void turnTo(int to) {
        way = to;
    }

    /** The nearest place of a way. */
    public int first(int of) {
        return first[of];
    }

    /** The place behind another. */
    public int next(int i) {
        return next[i];
    }

    /** Adds a place, unless it lies at the limit or beyond, or in a hole; {@code holes} is null where there are none. */
    public void add(int s, int piece, double distance, double limit, Holes holes) {
        if (!(distance < limit) || distance == Double.POSITIVE_INFINITY || holes != null && holes.passes(piece, distance)) {
            return;
        }
        if (count == t.length) {
            primitive = Arrays.copyOf(primitive, 2 * count);
            part = Arrays.copyOf(part, 2 * count);
            t = Arrays.copyOf(t, 2 * count);
            next = Arrays.copyOf(next, 2 * count);
        }
        int before = NONE;
        int behind = first[way];
        while (behind != NONE && !isBehind(behind, s, piece, distance)) {
            before = behind;
            behind = next[behind];
        }
        int at = count++;
        primitive[at] = s;
        part[at] = piece;
        t[at] = distance;
        next[at] = behind;
        if (before == NONE) {
            first[way] = at;
        } else {
            next[before] = at;
        }
    }

    private boolean isBehind(int i, int s, int piece, double distance) {
        return t[i] != distance ? t[i] > distance : primitive[i] != s ? primitive[i] > s : part[i] > piece;
    }
}
