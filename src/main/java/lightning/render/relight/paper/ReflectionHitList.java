package lightning.render.relight.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialSet;

/**
 * The paper's list of hits of one tile: for each level below the first, in the order of a walk, the shape that every ray hit, −1
 * for none. Points and lights follow from it without a search. Used for one tile after the other: one for each thread.
 */
public final class ReflectionHitList {
    /** The list of a tile without known levels. */
    public static final int[][] NONE = {};

    private final List<int[]> recorded = new ArrayList<>();
    private int[][] known = NONE;
    private int next;

    /**
     * Returns the part of a tile's list that is valid after an update; none if its rays may take other paths.
     *
     * @param mirrored with the materials that mirrors show afterwards
     */
    public static int[][] validAfter(int[][] before, UpdatePlan.Relight plan, Geometry mirrored) {
        int[][] updated = Arrays.stream(before).map(plan.shapes()::mapIndices).toArray(int[][]::new);
        boolean isTree = mirrored.materials().transparentCount() > 0;
        // Of a tree of levels another depth leaves out some in the middle.
        if (isTree && plan.oldDepth() != plan.newDepth()
                || plan.mirrors() != null && containsAny(plan.mirrors().materials().mirroringChanged(), updated, mirrored)) {
            return NONE;
        }
        return Arrays.copyOf(updated, isTree ? updated.length : Math.min(updated.length, plan.newDepth()));
    }

    /** Whether any of the shapes is of one of the materials. */
    private static boolean containsAny(MaterialSet materials, int[][] shapes, Geometry geometry) {
        return !materials.isEmpty() && Arrays.stream(shapes).flatMapToInt(Arrays::stream)
                .anyMatch(shape -> shape >= 0 && materials.contains(geometry.materialIndex(shape)));
    }

    /** Starts a tile with the levels that are known. */
    public void begin(int[][] shapes) {
        recorded.clear();
        known = shapes;
        next = 0;
    }

    /** Whether the next level is known. */
    public boolean hasNext() {
        return next < known.length;
    }

    /** The shapes of the next level; null where it is not known. */
    public int[] next() {
        return hasNext() ? known[next++] : null;
    }

    /** Drops the known shapes of all further levels. */
    public void dropRest() {
        next = known.length;
    }

    /** Adds the shapes of a level to the list to keep. */
    public void add(int[] shapes) {
        recorded.add(shapes);
    }

    /** The list to keep. */
    public int[][] list() {
        return recorded.toArray(int[][]::new);
    }
}
