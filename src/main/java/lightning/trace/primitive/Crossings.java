package lightning.trace.primitive;

import java.util.Arrays;

/** Where one way meets primitives, the nearest first; of equal ones the lowest primitive, then its lowest part. Reused. */
public final class Crossings {
    public int count;
    public int[] primitive = new int[8];
    public int[] part = new int[8];
    public double[] t = new double[8];

    /** Forgets all. */
    public void clear() {
        count = 0;
    }

    /** Adds a place, unless it lies at the limit or beyond, or in a hole; {@code holes} is null where there are none. */
    void add(int s, int piece, double distance, double limit, Holes holes) {
        if (!(distance < limit) || distance == Double.POSITIVE_INFINITY || holes != null && holes.passes(piece, distance)) {
            return;
        }
        if (count == t.length) {
            primitive = Arrays.copyOf(primitive, 2 * count);
            part = Arrays.copyOf(part, 2 * count);
            t = Arrays.copyOf(t, 2 * count);
        }
        int at = count++;
        for (; at > 0 && isBehind(at - 1, s, piece, distance); at--) {
            primitive[at] = primitive[at - 1];
            part[at] = part[at - 1];
            t[at] = t[at - 1];
        }
        primitive[at] = s;
        part[at] = piece;
        t[at] = distance;
    }

    private boolean isBehind(int i, int s, int piece, double distance) {
        return t[i] != distance ? t[i] > distance : primitive[i] != s ? primitive[i] > s : part[i] > piece;
    }
}
