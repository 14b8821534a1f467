package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.work.WorkerPool;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.relight.plan.LayerPlan;
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
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Computes the light in the fog of a job's target scene on all threads. Keeps the light of the last picture where nothing changed, and the
 * samples that see a light as long as neither the light moved nor a shape changed between them.
 */
final class FogBuilder {
    private final RenderJob job;
    private final WorkerPool workers;
    private final @Nullable PictureFog before;
    private long shadowRays;

    /** @param old cache of the last picture */
    FogBuilder(RenderJob job, WorkerPool workers, @Nullable PixelCache old) {
        this.job = job;
        this.workers = workers;
        before = job.plan() == null || old == null ? null : old.shown().fog();
    }

    /**
     * Returns the fog; null if the air is clear.
     *
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    @Nullable
    PictureFog build() {
        Scene scene = job.scene();
        FogMedium medium = FogMedium.of(scene);
        if (medium == null) {
            return null;
        }
        FogGrid grid = before != null ? before.grid() : new FogGrid(scene.camera(), scene.picture());
        WeightedLight[] lights = job.target().lights();
        float[] depths = depths(grid);
        var solver = new FogSolver(grid, medium, scene.world().fog().anisotropy(), depths, workers, job.progress());
        var shadows = new FogShadows(grid, job.target().geometry(), job.options().view(), job.options().engines(), workers,
                job.progress());
        @Nullable
        FogLight[] built = new FogLight[lights.length];
        for (int l = 0; l < lights.length; l++) {
            built[l] = light(l, lights[l], medium, depths, shadows, solver);
        }
        shadowRays += shadows.rayCount();
        return new PictureFog(grid, medium, depths, built);
    }

    private @Nullable FogLight light(int l, WeightedLight light, FogMedium medium, float[] depths, FogShadows shadows, FogSolver solver) {
        FogLight known = known(l);
        if (light.isDarkInFog()) {
            // Updated once it shines.
            return known != null && shapeChange(l).isEmpty() ? known : null;
        }
        LightSource source = light.source();
        if (known == null) {
            return solver.solve(source, shadows.visible(source, null, ShapeChange.NONE));
        }
        LightDifference difference = LightDifference.between(known.light(), light.light());
        if (difference.moved() || difference.shadows()) {
            return solver.solve(source, shadows.visible(source, null, ShapeChange.NONE));
        }
        if (!shapeChange(l).isEmpty()) {
            return solver.solve(source, shadows.visible(source, known.visible(), shapeChange(l)));
        }
        boolean isSame = difference.update() instanceof LightUpdate.Keep || difference.update() instanceof LightUpdate.Reweight;
        return isSame && known.hasDepths(depths) && known.medium().equals(medium)
                && known.anisotropy() == job.scene().world().fog().anisotropy() ? known : solver.solve(source, known.visible());
    }

    /** Returns the distances of the first surfaces; the same array as before if none changed. */
    private float[] depths(FogGrid grid) {
        if (before != null && job.shapeChange().isEmpty()) {
            return before.depths();
        }
        float[] depths = FogDepths.trace(grid, job.target().geometry(), workers, job.progress());
        return before != null && Arrays.equals(depths, before.depths()) ? before.depths() : depths;
    }

    private ShapeChange shapeChange(int l) {
        return requireNonNull(job.topPlan()).layers().get(l).shadows();
    }

    /** Returns the light in the last picture's fog whose samples can be kept; null if there is none. */
    private @Nullable FogLight known(int l) {
        if (before == null) {
            return null;
        }
        LayerPlan plan = requireNonNull(job.topPlan()).layers().get(l);
        FogLight known = plan.base() == null ? null : before.lights()[plan.base().index()];
        if (known == null || job.shapeChange() == ShapeChange.NONE) {
            return known;
        }
        // The change of shapes is that of the shapes which shadowed the layer.
        LayerStamp stamp = requireNonNull(plan.base()).stamp();
        return stamp != null && !(plan.update() instanceof LightUpdate.FullRecompute)
                && stamp.light().shadowCasters().equals(known.light().shadowCasters()) ? known : null;
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        return new WorkCounts(0, 0, 0, new RayCounts(0, 0, 0, shadowRays));
    }
}
