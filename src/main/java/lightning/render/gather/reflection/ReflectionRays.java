package lightning.render.gather.reflection;

import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.SurfelRays;
import lightning.render.trace.HitRows;

/**
 * Rays of reflection points, as they find surfels or parts of surfels.
 *
 * @param casters one for each thread
 * @param details whether they find parts
 * @param repeated points of paths before an edit
 */
record ReflectionRays(ReflectionPoints reflecting, ReflectionLinks links, ReflectionCaster[] casters, boolean details,
        RepeatedPoints repeated)
        implements SurfelRays {
    @Override
    public boolean isHit(int ray) {
        return links.isHit(ray) && (!details || links.key(ray) != links.detailKey(ray));
    }

    @Override
    public boolean mayBeFirst(int ray) {
        return repeated.mayBeFirst(ray, details);
    }

    @Override
    public long key(int ray) {
        return details ? links.detailKey(ray) : links.key(ray);
    }

    @Override
    public long seed(int p) {
        return reflecting.seed[p];
    }

    @Override
    public int rank(int p, long seed, int k) {
        SurfaceColumns s = reflecting.surface();
        return CellKeys.rank(seed, s.px[p], s.py[p], s.pz[p], k);
    }

    @Override
    public int knownSurfel(int worker, int ray) {
        return repeated.surfel(ray, details);
    }

    @Override
    public HitRows hits(int worker, int[] selected, int from, int to) {
        return casters[worker].hits(reflecting, selected, from, to, details);
    }
}
