package lightning.render.gather.reflection;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import lightning.render.gather.cell.Hash64;

/**
 * Places in the unit square, one in each cell of a grid, by which directions of a lobe are chosen. As in {@link lightning.render.gather.cell.DirectionTable}, neighboring
 * points have different parts of the cells. The second coordinate is an angle.
 */
public final class ReflectionDirections {
    private static final int PARTS = 4;
    private static final int VARIANTS = 16;
    /** Changes of a part's bits that spread the first parts evenly along both axes. */
    private static final byte[] PART_CHANGES = {0, 10, 13, 7, 8, 2, 5, 15, 4, 14, 9, 3, 12, 6, 1, 11};
    private static final int PATTERNS = PARTS * PARTS * VARIANTS;
    private static final Map<Integer, ReflectionDirections> KNOWN = new ConcurrentHashMap<>();

    final int side;
    public final int rays;
    private final float[] share;
    private final float[] cos;
    private final float[] sin;

    /**
     * Returns the places.
     *
     * @param side places along each side of the grid, an even number
     */
    public static ReflectionDirections of(int side) {
        return KNOWN.computeIfAbsent(side, ReflectionDirections::new);
    }

    private ReflectionDirections(int side) {
        this.side = side;
        rays = side * side;
        share = new float[PATTERNS * rays];
        cos = new float[PATTERNS * rays];
        sin = new float[PATTERNS * rays];
        for (int i = 0; i < PATTERNS * rays; i++) {
            long h = Hash64.mix(i + 1);
            int k = i % rays;
            int part = i / rays / VARIANTS;
            share[i] = coordinate(k / side, part % PARTS, h & 0xffffff);
            double angle = 2 * Math.PI * coordinate(k % side, part / PARTS, h >>> 24 & 0xffffff);
            cos[i] = (float) StrictMath.cos(angle);
            sin[i] = (float) StrictMath.sin(angle);
        }
    }

    private float coordinate(int cell, int part, long random) {
        return (float) ((cell + (part + random * 0x1p-24) / PARTS) / side);
    }

    /**
     * Returns a seed whose places lie in other parts of the cells than those of another seed and of lower numbers.
     *
     * @param number 1…15
     */
    static long seed(long seed, int number) {
        return seed ^ PART_CHANGES[number];
    }

    /** Returns the index of the first place of a point. */
    int first(long seed) {
        int part = (int) (seed & PARTS * PARTS - 1);
        return (int) (part * VARIANTS + (Hash64.mix(seed) & VARIANTS - 1)) * rays;
    }

    /** Returns the first coordinate of a place, 0…1. */
    double share(int index) {
        return share[index];
    }

    double cos(int index) {
        return cos[index];
    }

    double sin(int index) {
        return sin[index];
    }
}
