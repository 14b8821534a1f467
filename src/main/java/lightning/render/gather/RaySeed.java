package lightning.render.gather;

/**
 * Seeds of the directions of a point's rays. They depend on the place alone, not on the number of the surface: an edit of other objects
 * leaves them as they are.
 */
public final class RaySeed {
    private static final int SURFEL = CellKeys.LEVELS;

    private RaySeed() {}

    /**
     * Returns the seed of a gather point.
     *
     * @param level 0 for a point in a cell of the largest size
     */
    public static long ofPoint(float x, float y, float z, int level) {
        long bits = (long) Float.floatToRawIntBits(x) << 32 | Float.floatToRawIntBits(y) & 0xffffffffL;
        return Hash64.mix(Hash64.mix(bits) + ((long) Float.floatToRawIntBits(z) << 2) + level);
    }

    /** Returns the seed of a surfel. */
    public static long ofSurfel(float x, float y, float z) {
        return ofPoint(x, y, z, SURFEL);
    }
}
