package lightning.sample;

import java.util.List;
import java.util.SplittableRandom;

/**
 * Common part of the fuzzers. {@code -Dlightning.tries=N} sets the number of tries, {@code -Dlightning.fuzz.seed=S} another seed; a failed
 * try is identified by its number and repeated with the same seed. Without a number, the usual check makes a tenth of the tries of the
 * nightly one.
 */
public final class ByteFuzzer {
    private static final long SEED = Long.getLong("lightning.fuzz.seed", 1);
    private static final int PERCENT = Integer.getInteger("lightning.fuzz.percent", 100);

    private ByteFuzzer() {}

    /**
     * Returns the number of tries.
     *
     * @param nightly number of the nightly check
     */
    public static int tryCount(int nightly) {
        return Integer.getInteger("lightning.tries", (int) ((long) nightly * PERCENT / 100));
    }

    /** Returns the random generator of one try. */
    public static SplittableRandom random(int number) {
        return new SplittableRandom(SEED + number);
    }

    /**
     * Returns one of the texts with one to three mutations: inserts a byte or a bit, deletes bytes, or appends the end of another text.
     *
     * @param bits insertions that are hostile to the reader
     */
    public static byte[] mutate(List<byte[]> pool, SplittableRandom random, List<byte[]> bits) {
        byte[] bytes = pool.get(random.nextInt(pool.size())).clone();
        for (int i = random.nextInt(3); i >= 0; i--) {
            int position = random.nextInt(bytes.length + 1);
            int to = Math.min(bytes.length, position + random.nextInt(8));
            bytes = switch (random.nextInt(5)) {
                case 0 -> join(bytes, position, new byte[] {(byte) random.nextInt(256)}, bytes, position);
                case 1 -> join(bytes, position, new byte[0], bytes, to);
                case 2 -> {
                    byte[] donor = pool.get(random.nextInt(pool.size()));
                    yield join(bytes, position, new byte[] {' '}, donor, random.nextInt(donor.length + 1));
                }
                case 3 -> join(bytes, position, bits.get(random.nextInt(bits.size())), bytes, position);
                default -> join(bytes, position, bits.get(random.nextInt(bits.size())), bytes, to);
            };
        }
        return bytes;
    }

    private static byte[] join(byte[] a, int to, byte[] between, byte[] b, int rest) {
        byte[] all = new byte[to + between.length + b.length - rest];
        System.arraycopy(a, 0, all, 0, to);
        System.arraycopy(between, 0, all, to, between.length);
        System.arraycopy(b, rest, all, to + between.length, b.length - rest);
        return all;
    }
}
