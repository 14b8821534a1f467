package lightning.sample;

import java.util.List;
import java.util.SplittableRandom;

/**
 * What the fuzzers share. {@code -Dlightning.tries=N} makes N tries, {@code -Dlightning.fuzz.seed=S} others than the usual ones; a
 * try is told by its number, and made again by the same seed.
 */
public final class Fuzz {
    private static final long SEED = Long.getLong("lightning.fuzz.seed", 1);

    private Fuzz() {}

    /** How many tries to make. */
    public static int tries(int usual) {
        return Integer.getInteger("lightning.tries", usual);
    }

    /** The random numbers of one try. */
    public static SplittableRandom random(int number) {
        return new SplittableRandom(SEED + number);
    }

    /**
     * One of the texts with one to three changes: a byte or a bit put in, some bytes cut out, the end of another text.
     *
     * @param bits what is put in, hostile to the reader
     */
    public static byte[] mutated(List<byte[]> pool, SplittableRandom random, List<byte[]> bits) {
        byte[] bytes = pool.get(random.nextInt(pool.size())).clone();
        for (int i = random.nextInt(3); i >= 0; i--) {
            int at = random.nextInt(bytes.length + 1);
            int to = Math.min(bytes.length, at + random.nextInt(8));
            bytes = switch (random.nextInt(5)) {
                case 0 -> join(bytes, at, new byte[] {(byte) random.nextInt(256)}, bytes, at);
                case 1 -> join(bytes, at, new byte[0], bytes, to);
                case 2 -> {
                    byte[] other = pool.get(random.nextInt(pool.size()));
                    yield join(bytes, at, new byte[] {' '}, other, random.nextInt(other.length + 1));
                }
                case 3 -> join(bytes, at, bits.get(random.nextInt(bits.size())), bytes, at);
                default -> join(bytes, at, bits.get(random.nextInt(bits.size())), bytes, to);
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
