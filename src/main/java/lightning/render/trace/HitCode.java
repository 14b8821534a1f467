package lightning.render.trace;

/**
 * What anti-aliasing sees of a hit, in one number: the shape, the side of it that is seen, and its texture in coarse
 * steps. Neighboring pixels whose numbers differ have an edge between them. (Different things may get the same number
 * by chance; that only leaves out a finer sampling, and everyone leaves out the same.)
 */
public final class HitCode {
    /** Unit vectors at a right angle differ by more than this along some axis, so that a crease never hides. */
    private static final float SIDE_THRESHOLD = 0.75f;
    /** Steps of a texture from black to white. */
    private static final float SHADE_LEVELS = 8;
    private static final int FACTOR = 0x9E3779B1;

    private HitCode() {}

    /**
     * The number of a shape of that name. Java's own hash would not do: names that people give, as {@code 1P} and {@code 21}, have the
     * same one, and the edge between such shapes would never be found.
     */
    static int ofName(String name) {
        int h = name.length();
        for (int i = 0; i < name.length(); i++) {
            h = scramble(h + name.charAt(i) * FACTOR);
        }
        return h;
    }

    /** The number of a hit: the shape's own number and the unit normal. */
    public static int of(int shape, float nx, float ny, float nz) {
        return scramble((((shape * 3 + side(nx)) * 3 + side(ny)) * 3 + side(nz)) * FACTOR);
    }

    /** The number of a hit, its own number being {@code code}, whose material has a texture of this linear color there. */
    public static int withTexture(int code, float red, float green, float blue) {
        int shade = ((int) (red * SHADE_LEVELS) * 31 + (int) (green * SHADE_LEVELS)) * 31 + (int) (blue * SHADE_LEVELS);
        return scramble(code + shade * FACTOR);
    }

    private static int side(float n) {
        return n > SIDE_THRESHOLD / 2 ? 2 : n < -SIDE_THRESHOLD / 2 ? 0 : 1;
    }

    /** A number that stands for {@code code} seen at a place, 0 where the eye sees it: such numbers of one pixel are added. */
    public static int atDepth(int code, int depth) {
        return scramble(code + (depth + 1) * FACTOR);
    }

    /** Spreads the bits of a number over all of it. */
    static int scramble(int v) {
        int h = v;
        h = (h ^ h >>> 16) * 0x85EBCA6B;
        h = (h ^ h >>> 13) * 0xC2B2AE35;
        return h ^ h >>> 16;
    }
}
