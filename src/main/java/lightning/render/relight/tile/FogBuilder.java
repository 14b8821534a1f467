package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.cache.LayerStamp;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.LightDifference;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.LightSource;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.FogDepths;
import lightning.render.shading.fog.FogLight;
import lightning.render.shading.fog.FogShadows;
import lightning.render.shading.fog.FogSolver;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.ShapeChange;
import org.jspecify.annotations.Nullable;

/**
 * Computes the light in the fog of a scene along rays, on all threads. Keeps the light of the last picture where nothing changed, and the
 * samples that see a light as long as neither the light nor their ray moved nor a shape changed between them.
 */
final class FogBuilder {
    private final RenderJob job;
    private final PreparedScene target;
    private final WorkerPool workers;
    private final @Nullable LevelPlan plan;
    private final @Nullable PictureFog before;
    private final FogRays rays;
    /** For each ray the same one before, −1 for none; null if all rays are the same, or there were none. */
    private final int @Nullable [] sameRay;
    private final BitSet unknownRays = new BitSet();

    /**
     * @param target scene of the level whose camera rays or bounced rays they are
     * @param plan   update of that level; null in a first pass
     * @param before fog along the rays of the last picture; null for none
     */
    FogBuilder(RenderJob job, PreparedScene target, @Nullable LevelPlan plan, @Nullable PictureFog before, FogRays rays,
            WorkerPool workers) {
        this.job = job;
        this.target = target;
        this.plan = plan;
        this.before = plan == null ? null : before;
        this.rays = rays;
        this.workers = workers;
        sameRay = this.before == null || this.before.rays() == rays ? null
                : sameRays((BounceRays) rays, (BounceRays) this.before.rays());
        for (int i = 0; sameRay != null && i < sameRay.length; i++) {
            unknownRays.set(i, sameRay[i] < 0);
        }
    }

    private static int[] sameRays(BounceRays now, BounceRays before) {
        int[] same = new int[now.count()];
        Arrays.setAll(same, i -> now.find(i, before));
        return same;
    }

    /** Fog and the number of shadow rays cast for it. */
    record BuiltFog(PictureFog fog, RayCounts shadowRays) {}

    /**
     * Builds the fog.
     *
     * @param progress progress of this part of the job
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    BuiltFog build(FogMedium medium, ProgressPart progress) {
        WeightedLight[] lights = target.lights();
        float[] depths = depths();
        double anisotropy = target.scene().world().fog().anisotropy();
        var solver = new FogSolver(rays, medium, anisotropy, depths, workers, job.progress());
        var shadows = new FogShadows(rays, target.geometry(), job.options().view(), job.options().engines(), workers, lights.length,
                progress);
        @Nullable
        FogLight[] built = new FogLight[lights.length];
        for (int l = 0; l < lights.length; l++) {
            built[l] = light(l, lights[l], medium, depths, shadows, solver);
        }
        return new BuiltFog(new PictureFog(rays, medium, depths, built), shadows.rays());
    }

    private @Nullable FogLight light(int l, WeightedLight light, FogMedium medium, float[] depths, FogShadows shadows, FogSolver solver) {
        FogLight known = known(l);
        if (light.isDarkInFog()) {
            // Computed once it shines, unless it and the fog stay the same until then.
            return known != null && sameRay == null && shapeChange(l).isEmpty()
                    && isCurrent(known, LightDifference.between(known.light(), light.light()), medium, depths) ? known : null;
        }
        LightSource source = light.source();
        if (known == null) {
            return solver.solve(source, shadows.visible(l, source));
        }
        LightDifference difference = LightDifference.between(known.light(), light.light());
        if (difference.moved() || difference.shadows()) {
            return solver.solve(source, shadows.visible(l, source));
        }
        if (sameRay != null || !shapeChange(l).isEmpty()) {
            return solver.solve(source, shadows.visibleAfter(l, source, visibleBefore(known), unknownRays, shapeChange(l)));
        }
        return isCurrent(known, difference, medium, depths) ? known : solver.solve(source, known.visible());
    }

    /** Returns whether nothing but the weight of a light changes in the fog. */
    private boolean isCurrent(FogLight known, LightDifference difference, FogMedium medium, float[] depths) {
        boolean isSame = difference.update() instanceof LightUpdate.Keep || difference.update() instanceof LightUpdate.Reweight;
        return isSame && known.hasDepths(depths) && known.medium().equals(medium)
                && known.anisotropy() == target.scene().world().fog().anisotropy();
    }

    /** Returns the samples of each ray that saw a light before. */
    private int[] visibleBefore(FogLight known) {
        if (sameRay == null) {
            return known.visible();
        }
        int[] visible = new int[sameRay.length];
        Arrays.setAll(visible, i -> sameRay[i] < 0 ? 0 : known.visible()[sameRay[i]]);
        return visible;
    }

    /** Returns the distances of the first surfaces; the same array as before if none changed. */
    private float[] depths() {
        if (before != null && sameRay == null && job.shapeChange().isEmpty()) {
            return before.depths();
        }
        float[] depths = FogDepths.trace(rays, target.geometry(), workers, job.progress());
        return before != null && Arrays.equals(depths, before.depths()) ? before.depths() : depths;
    }

    private LayerPlan layerPlan(int l) {
        return requireNonNull(plan).layers().get(l);
    }

    private ShapeChange shapeChange(int l) {
        return layerPlan(l).shadows();
    }

    /** Returns the light in the last picture's fog whose samples can be kept; null if there is none. */
    private @Nullable FogLight known(int l) {
        if (before == null) {
            return null;
        }
        LayerPlan layer = layerPlan(l);
        FogLight known = layer.base() == null ? null : before.lights()[layer.base().index()];
        if (known == null || job.shapeChange() == ShapeChange.NONE) {
            return known;
        }
        // The change of shapes is that of the shapes which shadowed the layer.
        LayerStamp stamp = requireNonNull(layer.base()).stamp();
        return stamp != null && !(layer.update() instanceof LightUpdate.FullRecompute)
                && stamp.light().shadowCasters().equals(known.light().shadowCasters()) ? known : null;
    }
}
