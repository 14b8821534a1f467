package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.FogDepths;
import lightning.render.shading.fog.FogLight;
import lightning.render.shading.fog.FogShadows;
import lightning.render.shading.fog.FogSolver;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.Geometry;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Computes the light in the fog of a scene for a full trace. */
final class FogTracer {
    private final Geometry geometry;
    private final Scene scene;
    private final WorkerPool workers;
    private final Progress progress;
    private final EngineChoice engines;
    private long shadowRays;

    FogTracer(Geometry geometry, Scene scene, EngineChoice engines, WorkerPool workers, Progress progress) {
        this.geometry = geometry;
        this.scene = scene;
        this.workers = workers;
        this.progress = progress.cancellationOnly();
        this.engines = engines;
    }

    /**
     * Returns the fog; null if the air is clear.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    @Nullable
    PictureFog trace(WeightedLight[] lights) {
        FogMedium medium = FogMedium.of(scene);
        if (medium == null) {
            return null;
        }
        FogGrid grid = new FogGrid(scene.camera(), scene.picture());
        float[] depths = FogDepths.trace(grid, geometry, workers, progress);
        var solver = new FogSolver(grid, medium, scene.world().fog().anisotropy(), depths, workers, progress);
        var shadows = new FogShadows(grid, geometry, ViewEffects.ALL, engines, workers, progress);
        @Nullable
        FogLight[] traced = new FogLight[lights.length];
        for (int l = 0; l < lights.length; l++) {
            traced[l] = lights[l].isDarkInFog() ? null
                    : solver.solve(lights[l].source(), shadows.visible(lights[l].source(), null, ShapeChange.NONE));
        }
        shadowRays += shadows.rayCount();
        return new PictureFog(grid, medium, depths, traced);
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return new RayCounts(0, 0, 0, shadowRays);
    }
}
