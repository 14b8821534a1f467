package lightning.render.gather.build;

import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.gather.ray.SurfelRays;
import lightning.render.trace.HitRows;

/** Rays of gather points or surfels. */
record PathRays(RaySources sources, RayLinks links, PathCaster caster) implements SurfelRays {
    @Override
    public boolean isHit(int ray) {
        return links.isHit(ray);
    }

    @Override
    public long key(int ray) {
        return links.key(ray);
    }

    @Override
    public long seed(int p) {
        return sources.seed(p);
    }

    @Override
    public int rank(int p, long seed, int k) {
        return sources.rank(p, seed, k);
    }

    @Override
    public int knownSurfel(int worker, int ray) {
        return caster.knownSurfel(worker, sources, ray);
    }

    @Override
    public HitRows hits(int worker, int[] selected, int from, int to) {
        return caster.hits(worker, sources, selected, from, to);
    }
}
