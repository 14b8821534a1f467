package lightning.format.matte;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;

/** Ids of names: the hash MurmurHash3_32 with seed 0, as the bits of a float. */
public final class MatteId {
    private static final int FIRST_FACTOR = 0xcc9e2d51;
    private static final int SECOND_FACTOR = 0x1b873593;
    private static final int EXPONENT_MASK = 0x7f800000;
    private static final int LOWEST_EXPONENT_BIT = 0x00800000;

    private MatteId() {}

    /** Returns the hash of a name's UTF-8 bytes. */
    static int hash(String name) {
        byte[] bytes = name.getBytes(StandardCharsets.UTF_8);
        int hash = 0;
        int word = 0;
        for (int i = 0; i < bytes.length; i++) {
            word |= (bytes[i] & 0xff) << 8 * (i & 3);
            if ((i & 3) == 3) {
                hash = Integer.rotateLeft(hash ^ scramble(word), 13) * 5 + 0xe6546b64;
                word = 0;
            }
        }
        hash ^= scramble(word) ^ bytes.length;
        hash = (hash ^ hash >>> 16) * 0x85ebca6b;
        hash = (hash ^ hash >>> 13) * 0xc2b2ae35;
        return hash ^ hash >>> 16;
    }

    private static int scramble(int word) {
        return Integer.rotateLeft(word * FIRST_FACTOR, 15) * SECOND_FACTOR;
    }

    /**
     * Returns the bits of the float that stands for a name. An exponent of a subnormal number or of an infinity or NaN becomes the next
     * one, since programs may change such values.
     */
    public static int bits(String name) {
        int hash = hash(name);
        int exponent = hash & EXPONENT_MASK;
        return exponent == 0 || exponent == EXPONENT_MASK ? hash ^ LOWEST_EXPONENT_BIT : hash;
    }

    /** Returns bits as eight hexadecimal digits. */
    static String hex(int bits) {
        return HexFormat.of().toHexDigits(bits);
    }
}
