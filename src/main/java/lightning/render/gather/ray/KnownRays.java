package lightning.render.gather.ray;

import java.util.Arrays;

/** Rays of gather points or surfels before an edit. A point with the same place and normal casts the same rays. Immutable. */
public final class KnownRays {
    public static final int UNKNOWN = -1;

    private final RaySources sources;
    private final RayLinks links;
    /** Open hash table of the points; {@link #UNKNOWN} in an empty slot. */
    private final int[] slots;

    /** @param links of all points; later points have no rays */
    public KnownRays(RaySources sources, RayLinks links) {
        this.sources = sources;
        this.links = links;
        slots = new int[Integer.highestOneBit(Math.max(1, links.points())) * 4];
        Arrays.fill(slots, UNKNOWN);
        for (int p = 0; p < links.points(); p++) {
            int slot = slot(sources, p);
            if (slots[slot] == UNKNOWN) {
                slots[slot] = p;
            }
        }
    }

    /** Returns the slot of a point, or the empty one where it belongs. */
    private int slot(RaySources from, int p) {
        long seed = from.seed(p);
        int slot = from.rank(p, seed, 0) & slots.length - 1;
        while (slots[slot] != UNKNOWN && !(RaySources.haveSameBits(from, p, sources, slots[slot])
                && sources.seed(slots[slot]) == seed)) {
            slot = slot + 1 & slots.length - 1;
        }
        return slot;
    }

    /** Returns the point that cast the rays of a point; {@link #UNKNOWN} for none. */
    public int find(RaySources now, int p) {
        return slots[slot(now, p)];
    }

    /** Returns the surfel that a ray hit; {@link RayLinks#MISS} for none. */
    public int surfel(int ray) {
        return links.surfel(ray);
    }
}
