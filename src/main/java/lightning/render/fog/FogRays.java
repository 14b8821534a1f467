package lightning.render.fog;

/** Rays along which the fog of a picture is sampled, in groups of rays that are close together. */
public sealed interface FogRays permits FogGrid, BounceRays {
    /** Largest number of rays of a group. */
    int GROUP = 1024;

    /** Returns the grid of camera rays that they are, or that they start from. */
    FogGrid grid();

    /** Returns the number of rays. */
    int count();

    /** Sets a ray. */
    void set(int ray, FogRay to);

    /** Returns the number of groups. Each ray is in one of them. */
    int groupCount();

    /**
     * Writes the rays of a group.
     *
     * @param to receives them, at most {@link #GROUP}
     * @return the number of rays
     */
    int writeGroup(int group, int[] to);
}
