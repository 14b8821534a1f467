package lightning.render.relight.paper;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialSet;
import org.jspecify.annotations.Nullable;

/**
 * The paper's reflection hit list of one tile: the shape that each ray hit, −1 for none, for each level below the first in
 * traversal order. Points and lights follow from it without intersection tests. Reused for one tile after the other: use one
 * instance per thread.
 */
public final class ReflectionHitList {
    /** List of a tile without cached levels. */
    public static final int[][] NONE = {};

    private final List<int[]> recorded = new ArrayList<>();
    private int[][] known = NONE;
    private int next;

    /**
     * Returns the part of a tile's list that is valid after an update; none if its rays may take other paths.
     *
     * @param mirrored geometry with the materials that mirrors show afterwards
     */
    public static int[][] validAfter(int[][] before, UpdatePlan.Relight plan, Geometry mirrored) {
        int[][] updated = Arrays.stream(before).map(plan.shapes()::mapIndices).toArray(int[][]::new);
        boolean isTree = mirrored.materials().clearCount() > 0;
        // With another depth, a tree of levels gains or loses levels in the middle of the list.
        if (isTree && plan.oldDepth() != plan.newDepth()
                || plan.mirrors() != null && containsAny(plan.mirrors().materials().mirroringChanged(), updated, mirrored)) {
            return NONE;
        }
        return Arrays.copyOf(updated, isTree ? updated.length : Math.min(updated.length, plan.newDepth()));
    }

    /** Returns whether any of the shapes has one of the materials. */
    private static boolean containsAny(MaterialSet materials, int[][] shapes, Geometry geometry) {
        return !materials.isEmpty() && Arrays.stream(shapes).flatMapToInt(Arrays::stream)
                .anyMatch(shape -> shape >= 0 && materials.contains(geometry.materialIndex(shape)));
    }

    /** Starts a tile with its cached levels. */
    public void begin(int[][] shapes) {
        recorded.clear();
        known = shapes;
        next = 0;
    }

    /** Returns whether the next level is cached. */
    public boolean hasNext() {
        return next < known.length;
    }

    /** Returns the shapes of the next level; null if it is not cached. */
    public int @Nullable [] next() {
        return hasNext() ? known[next++] : null;
    }

    /** Drops the cached shapes of all further levels. */
    public void dropRest() {
        next = known.length;
    }

    /** Appends the shapes of a level to the new list. */
    public void add(int[] shapes) {
        recorded.add(shapes);
    }

    /** Returns the new list. */
    public int[][] list() {
        return recorded.toArray(int[][]::new);
    }
}
