package lightning.render.gather.reflection;

import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.SurfelRays;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/**
 * Rays of reflection points, as they find surfels or parts of surfels.
 *
 * @param casters one for each thread
 * @param details whether they find parts
 * @param memo    paths before an edit
 * @param known   for each point that of the memo
 */
public record ReflectionRays(ReflectionPoints reflecting, ReflectionLinks links, ReflectionCaster[] casters, boolean details,
        @Nullable ReflectionMemo memo, int[] known)
        implements SurfelRays {
    @Override
    public int points() {
        return links.points();
    }

    @Override
    public int raysPerPoint() {
        return links.raysPerPoint();
    }

    @Override
    public boolean isHit(int ray) {
        return links.isHit(ray) && (!details || links.key(ray) != links.detailKey(ray));
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
        int point = known[ray / raysPerPoint()];
        return memo == null || point == ReflectionMemo.NONE ? RayLinks.MISS : memo.surfel(point, ray % raysPerPoint(), details);
    }

    @Override
    public HitRows hits(int worker, int[] selected, int from, int to) {
        return casters[worker].hits(reflecting, selected, from, to, details);
    }
}
