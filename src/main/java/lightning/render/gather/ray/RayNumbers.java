package lightning.render.gather.ray;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import org.jspecify.annotations.Nullable;

/** Numbers below a limit, one for each ray: 16 bits each, and as many more as the limit needs, rounded to a power of two. */
final class RayNumbers {
    /** Rays from a multiple of this on share no memory with those before, so that threads may write them. */
    static final int ALIGNMENT = Integer.SIZE;

    private static final int WORD_SHIFT = 5;

    private final char[] low;
    /** Higher bits of all rays in words; null if there are none. */
    private final int @Nullable [] high;
    /** Logarithm of the number of higher bits per ray. */
    private final int shift;

    /** @param limit greater than any number */
    RayNumbers(int rays, int limit) {
        low = new char[rays];
        int bits = Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(1, limit - 1)) - Character.SIZE;
        shift = bits <= 1 ? 0 : Integer.SIZE - Integer.numberOfLeadingZeros(bits - 1);
        high = bits <= 0 ? null : new int[(int) ((((long) rays << shift) + Integer.SIZE - 1) / Integer.SIZE)];
    }

    private RayNumbers(char[] low, int @Nullable [] high, int shift) {
        this.low = low;
        this.high = high;
        this.shift = shift;
    }

    void writeTo(ColumnWriter out) throws IOException {
        out.writeArray(low);
        out.writeArray(high);
        out.writeInt(shift);
    }

    static RayNumbers readFrom(ColumnReader in) throws IOException {
        return new RayNumbers(in.readChars(), in.readOptionalInts(), in.readInt());
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

    /** Writes the numbers of consecutive rays, in their order. */
    void read(int from, int count, int[] to) {
        int bits = 1 << shift;
        int mask = high == null ? 0 : mask();
        int end = from + count;
        for (int ray = from; ray < end;) {
            int higher = high == null ? 0 : high[word(ray)] >>> (ray << shift);
            int stop = high == null ? end : Math.min(end, (word(ray) + 1) << WORD_SHIFT - shift);
            for (; ray < stop; ray++) {
                to[ray - from] = low[ray] | (higher & mask) << Character.SIZE;
                higher >>>= bits;
            }
        }
    }

    int get(int ray) {
        return high == null ? low[ray] : low[ray] | (high[word(ray)] >>> (ray << shift) & mask()) << Character.SIZE;
    }

    private int word(int ray) {
        return ray >>> WORD_SHIFT - shift;
    }

    private int mask() {
        return (1 << (1 << shift)) - 1;
    }

    long bytes() {
        return 2L * low.length + (high == null ? 0 : 4L * high.length);
    }
}
