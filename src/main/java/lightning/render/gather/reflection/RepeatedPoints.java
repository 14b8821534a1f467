package lightning.render.gather.reflection;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.gather.ray.RayLinks;
import org.jspecify.annotations.Nullable;

/** Reflection points of a memo that are found again while points are placed. Without a memo there are none. */
final class RepeatedPoints {
    private final @Nullable ReflectionMemo memo;
    private final int raysPerPoint;
    /** For each point or copy that of the memo; {@link ReflectionMemo#NONE} for others. */
    private int[] known = {};
    /** Points and copies of which rays may meet something else than before. */
    private boolean[] isChanged = {};
    private int count;
    /** For each point and copy of the memo whether it was found. */
    private final boolean[] isFound;

    RepeatedPoints(@Nullable ReflectionMemo memo, int raysPerPoint) {
        this.memo = memo;
        this.raysPerPoint = raysPerPoint;
        isFound = new boolean[memo == null ? 0 : memo.pointCount()];
    }

    /** Adds the last of some points. */
    void addPoint(ReflectionPoints points) {
        add(memo == null ? ReflectionMemo.NONE : memo.find(points, points.count() - 1));
    }

    /** Adds copy {@code k} of a point, 1 or more. */
    void addCopy(int p, int k) {
        add(memo == null || known[p] == ReflectionMemo.NONE ? ReflectionMemo.NONE : memo.copy(known[p], k));
    }

    private void add(int old) {
        if (count == known.length) {
            known = Arrays.copyOf(known, Math.max(1024, 2 * count));
            isChanged = Arrays.copyOf(isChanged, known.length);
        }
        known[count++] = old;
        if (old != ReflectionMemo.NONE) {
            isFound[old] = true;
        }
    }

    /** Returns whether the rays of a point are those of a point of the memo. */
    boolean isKnown(int p) {
        return known[p] != ReflectionMemo.NONE && !isChanged[p];
    }

    /**
     * Forgets points and copies of which a ray may meet something else than before. Threads may test different ones at the same time.
     *
     * @param from first of them, before {@code to}
     */
    void forgetChanged(ReflectionPoints points, int from, int to, ReflectionCaster caster) {
        for (int p = from; memo != null && memo.hasChanges() && p < to; p++) {
            if (isKnown(p) && caster.mayChange(points, p, memo)) {
                isChanged[p] = true;
                isFound[known[p]] = false;
            }
        }
    }

    /** Writes the rays of a known point. */
    void write(int p, ReflectionLinks links) {
        requireNonNull(memo).write(known[p], links, p);
    }

    /** Returns the sum of {@link lightning.render.gather.ray.InverseLengths} of a known point, which is no copy. */
    long inverseLengths(int p) {
        return requireNonNull(memo).inverseLengths(known[p]);
    }

    /** Returns the number that what a ray of a known point meets had before the edit: a surfel or, after all surfels, a cell of the sky. */
    int number(int p, int k) {
        return requireNonNull(memo).number(known[p] * raysPerPoint + k);
    }

    /** Returns the number of surfels before the edit, with their parts. */
    int surfelCount() {
        return memo == null ? 0 : memo.surfelCount();
    }

    /**
     * Returns the surfel before the edit that is the hit of a ray, now as well.
     *
     * @param isPart whether parts of surfels are wanted
     * @return {@link RayLinks#MISS} for none
     */
    int surfel(int ray, boolean isPart) {
        int p = ray / raysPerPoint;
        int surfel = isKnown(p) ? surfelOf(ray, isPart) : RayLinks.MISS;
        return surfel != RayLinks.MISS && requireNonNull(memo).firstRay(surfel) == oldRay(ray) ? surfel : RayLinks.MISS;
    }

    /** Returns whether a ray may be the first that meets its surfel. It is not if the first one of before the edit was found. */
    boolean mayBeFirst(int ray, boolean isPart) {
        if (!isKnown(ray / raysPerPoint)) {
            return true;
        }
        int surfel = surfelOf(ray, isPart);
        int first = surfel == RayLinks.MISS ? -1 : requireNonNull(memo).firstRay(surfel);
        return first < 0 || first == oldRay(ray) || !isFound[first / raysPerPoint];
    }

    private int oldRay(int ray) {
        return known[ray / raysPerPoint] * raysPerPoint + ray % raysPerPoint;
    }

    private int surfelOf(int ray, boolean isPart) {
        return requireNonNull(memo).surfel(oldRay(ray), isPart);
    }
}
