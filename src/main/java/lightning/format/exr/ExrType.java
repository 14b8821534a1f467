package lightning.format.exr;

import java.nio.ByteBuffer;

/** What the numbers of a channel are; the order is that of their codes in a file. */
public enum ExrType {
    /** Whole numbers of 32 bits, 0 and up. */
    UINT(4),
    /** Floats of 16 bits. */
    HALF(2),
    /** Floats of 32 bits. */
    FLOAT(4);

    /** The largest number of 16 bits. */
    public static final float MAX_HALF = 65504;

    private final int bytes;

    ExrType(int bytes) {
        this.bytes = bytes;
    }

    /** The bytes of a number. */
    public int bytes() {
        return bytes;
    }

    /**
     * Puts a number. HALF is the nearest, of two the even one; what is larger than any is {@link #MAX_HALF}, so that no finite
     * number becomes infinite.
     */
    void put(ByteBuffer buffer, int offset, float v) {
        switch (this) {
            case UINT -> buffer.putInt(offset, (int) (long) v);
            case HALF -> buffer.putShort(offset, Float.floatToFloat16(Float.isFinite(v) ? Math.clamp(v, -MAX_HALF, MAX_HALF) : v));
            // As raw bits, because a float register may change the payload of a NaN.
            case FLOAT -> buffer.putInt(offset, Float.floatToRawIntBits(v));
        }
    }

    float get(ByteBuffer buffer, int offset) {
        return switch (this) {
            case UINT -> Integer.toUnsignedLong(buffer.getInt(offset));
            case HALF -> Float.float16ToFloat(buffer.getShort(offset));
            case FLOAT -> Float.intBitsToFloat(buffer.getInt(offset));
        };
    }
}
