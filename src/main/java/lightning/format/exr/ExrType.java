package lightning.format.exr;

import java.nio.ByteBuffer;

/** Data type of a channel; the order is that of the codes in a file. */
public enum ExrType {
    /** Unsigned 32-bit integer. */
    UINT(4),
    /** 16-bit float. */
    HALF(2),
    /** 32-bit float. */
    FLOAT(4);

    /** Largest finite half. */
    public static final float MAX_HALF = 65504;

    private final int bytes;

    ExrType(int bytes) {
        this.bytes = bytes;
    }

    /** Returns the size of a value in bytes. */
    public int bytes() {
        return bytes;
    }

    /**
     * Writes a value. HALF rounds to nearest even; larger values become {@link #MAX_HALF}, so that no finite value becomes
     * infinite.
     */
    void put(ByteBuffer buffer, int offset, float v) {
        switch (this) {
            case UINT -> buffer.putInt(offset, (int) (long) v);
            case HALF -> buffer.putShort(offset, Float.floatToFloat16(Float.isFinite(v) ? Math.clamp(v, -MAX_HALF, MAX_HALF) : v));
            // Copy raw bits: a float register may change the payload of a NaN.
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
