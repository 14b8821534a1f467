package lightning.render.trace;

/**
 * Hash of a hit for the edge detection of anti-aliasing: shape, visible side, and quantized texture. Neighboring pixels with
 * different codes have an edge between them. Different hits may collide; that only skips some samples, and does so identically
 * in every engine.
 */
public final class HitCode {
    /** Perpendicular unit vectors differ by more than this along some axis, so every crease is detected. */
    private static final float SIDE_THRESHOLD = 0.75f;
    /** Quantization steps of a texture from black to white. */
    private static final float SHADE_LEVELS = 8;
    private static final int FACTOR = 0x9E3779B1;

    private HitCode() {}

    /**
     * Returns the hash of a shape name. {@link String#hashCode} is not sufficient: common names such as {@code 1P} and
     * {@code 21} collide, and the edge between such shapes would never be found.
     */
    static int ofName(String name) {
        int h = name.length();
        for (int i = 0; i < name.length(); i++) {
            h = scramble(h + name.charAt(i) * FACTOR);
        }
        return h;
    }

    /** Returns the code of a hit from the shape's hash and the unit normal. */
    public static int of(int shape, float nx, float ny, float nz) {
        return scramble((((shape * 3 + side(nx)) * 3 + side(ny)) * 3 + side(nz)) * FACTOR);
    }

    /** Combines the code of a hit with the linear color of its texture. */
    public static int withTexture(int code, float red, float green, float blue) {
        int shade = ((int) (red * SHADE_LEVELS) * 31 + (int) (green * SHADE_LEVELS)) * 31 + (int) (blue * SHADE_LEVELS);
        return scramble(code + shade * FACTOR);
    }

    private static int side(float n) {
        return n > SIDE_THRESHOLD / 2 ? 2 : n < -SIDE_THRESHOLD / 2 ? 0 : 1;
    }

    /** Returns the code of a hit at a reflection depth, 0 for camera rays. The codes of one pixel are added. */
    public static int atDepth(int code, int depth) {
        return scramble(code + (depth + 1) * FACTOR);
    }

    /** Distributes the bits of a number over the whole word. */
    static int scramble(int v) {
        int h = v;
        h = (h ^ h >>> 16) * 0x85EBCA6B;
        h = (h ^ h >>> 13) * 0xC2B2AE35;
        return h ^ h >>> 16;
    }
}
