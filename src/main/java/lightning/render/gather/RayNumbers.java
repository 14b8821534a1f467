package lightning.render.gather;

/** Numbers below a limit, one for each ray: 16 bits each, and as many more as the limit needs, rounded to a power of two. */
final class RayNumbers {
    /** Rays from a multiple of this on share no memory with those before, so that threads may write them. */
    static final int ALIGNMENT = Integer.SIZE;

    private final char[] low;
    /** Higher bits of all rays in words; null if there are none. */
    private final int[] high;
    /** Logarithm of the number of higher bits per ray. */
    private final int shift;

    /** @param limit greater than any number */
    RayNumbers(int rays, int limit) {
        low = new char[rays];
        int bits = Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(1, limit - 1)) - Character.SIZE;
        shift = bits <= 1 ? 0 : Integer.SIZE - Integer.numberOfLeadingZeros(bits - 1);
        high = bits <= 0 ? null : new int[(int) ((((long) rays << shift) + Integer.SIZE - 1) / Integer.SIZE)];
    }

    int count() {
        return low.length;
    }

    /** Sets the number of a ray that has none yet. */
    void set(int ray, int number) {
        low[ray] = (char) number;
        if (high != null) {
            high[word(ray)] |= number >>> Character.SIZE << (ray << shift);
        }
    }

    int get(int ray) {
        return high == null ? low[ray] : low[ray] | (high[word(ray)] >>> (ray << shift) & mask()) << Character.SIZE;
    }

    private int word(int ray) {
        return ray >>> 5 - shift;
    }

    private int mask() {
        return (1 << (1 << shift)) - 1;
    }

    /** Writes the numbers of rays {@code from … from + count − 1}. */
    void copy(int from, int count, int[] to) {
        if (high == null) {
            for (int i = 0; i < count; i++) {
                to[i] = low[from + i];
            }
            return;
        }
        int mask = mask();
        int wordShift = 5 - shift;
        for (int i = 0; i < count; i++) {
            int ray = from + i;
            to[i] = low[ray] | (high[ray >>> wordShift] >>> (ray << shift) & mask) << Character.SIZE;
        }
    }

    long bytes() {
        return 2L * low.length + (high == null ? 0 : 4L * high.length);
    }
}
