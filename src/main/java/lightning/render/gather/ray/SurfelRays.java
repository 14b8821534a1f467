package lightning.render.gather.ray;

import lightning.render.trace.HitRows;

/** Rays that find surfels: each point casts the same number. */
public interface SurfelRays {
    RayHits links();

    default int points() {
        return links().points();
    }

    default int raysPerPoint() {
        return links().raysPerPoint();
    }

    /** Returns whether a ray meets a surfel. */
    boolean isHit(int ray);

    /** Returns whether a ray that meets a surfel may be the one of the lowest rank; false only if it is known that another one is. */
    default boolean mayBeFirst(int ray) {
        return true;
    }

    /** Returns the key of the cell that a ray hit. */
    long key(int ray);

    /** Returns the seed of a point, for {@link #rank}. */
    long seed(int p);

    /** Returns the rank of ray {@code k} of a point, as {@link lightning.render.gather.cell.CellKeys#rank}. */
    int rank(int p, long seed, int k);

    /** Returns the surfel of the paths before an edit that a ray hits; {@link RayLinks#MISS} for none. */
    int knownSurfel(int worker, int ray);

    /** Casts some rays again and returns what they hit, as {@link lightning.render.gather.build.GatherCaster#hits}. */
    HitRows hits(int worker, int[] selected, int from, int to);
}
