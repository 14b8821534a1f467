package lightning.render.fulltrace;

import java.util.Arrays;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.BounceTracer;
import lightning.render.shading.fog.FogDepths;
import lightning.render.shading.fog.FogLight;
import lightning.render.shading.fog.FogShadows;
import lightning.render.shading.fog.FogSolver;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the light in the fog of a scene for a full trace. */
final class FogTracer {
    private final Geometry geometry;
    private final Scene scene;
    private final WorkerPool workers;
    private final ProgressPart progress;
    private final EngineChoice engines;
    private RayCounts rays = RayCounts.NONE;

    FogTracer(Geometry geometry, Scene scene, EngineChoice engines, WorkerPool workers, ProgressPart progress) {
        this.geometry = geometry;
        this.scene = scene;
        this.workers = workers;
        this.progress = progress;
        this.engines = engines;
    }

    /**
     * Returns the fog along camera rays; null if the air is clear.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    @Nullable
    PictureFog trace(WeightedLight[] lights) {
        FogMedium medium = FogMedium.of(scene);
        return medium == null ? null : trace(new FogGrid(scene.camera(), scene.picture()), medium, lights);
    }

    /**
     * Returns the fog along bounced rays; null if no light is seen there.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    @Nullable
    PictureFog traceBounces(WeightedLight[] lights) {
        FogMedium medium = FogMedium.of(scene);
        if (medium == null || Arrays.stream(lights).allMatch(WeightedLight::isDarkInFog)) {
            return null;
        }
        BounceRays rays = BounceTracer.trace(new FogGrid(scene.camera(), scene.picture()), geometry, scene, workers, progress);
        return rays == null ? null : trace(rays, medium, lights);
    }

    private PictureFog trace(FogRays rays, FogMedium medium, WeightedLight[] lights) {
        float[] depths = FogDepths.trace(rays, geometry, workers, progress);
        var solver = new FogSolver(rays, medium, scene.world().fog().anisotropy(), depths, workers, progress);
        var shadows = new FogShadows(rays, geometry, ViewEffects.ALL, engines, workers, lights.length, progress);
        @Nullable
        FogLight[] traced = new FogLight[lights.length];
        for (int l = 0; l < lights.length; l++) {
            traced[l] = lights[l].isDarkInFog() ? null : solver.solve(lights[l].source(), shadows.visible(l, lights[l].source()));
        }
        this.rays = this.rays.plus(shadows.rays());
        return new PictureFog(rays, medium, depths, traced);
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return rays;
    }
}
