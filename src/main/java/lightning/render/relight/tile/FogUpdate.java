package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.fog.BounceRays;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogMedium;
import lightning.render.fog.FogRays;
import lightning.render.shading.RayCounts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.fog.BounceTracer;
import lightning.render.shading.fog.PictureFog;
import org.jspecify.annotations.Nullable;

/** Update of the fog of a job's target scenes: along camera rays, and along bounced rays of the scene that mirrors show. */
final class FogUpdate {
    /** Usual share of fog in the time of a job that traces it, after indirect light. */
    private static final double SHARE = 0.5;

    private final RenderJob job;
    private final WorkerPool workers;
    private final @Nullable PixelCache old;
    private RayCounts shadowRays = RayCounts.NONE;

    /** @param old cache of the last picture */
    FogUpdate(RenderJob job, WorkerPool workers, @Nullable PixelCache old) {
        this.job = job;
        this.workers = workers;
        this.old = job.plan() == null ? null : old;
    }

    /**
     * Returns the job with its fog.
     *
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    RenderJob apply() {
        ProgressPart part = new ProgressPart(job.progress(), 0, SHARE);
        RenderJob shown = job.withFog(cameraFog(part.section(0, 2)));
        shown = shown.fog() == null ? shown : shown.withProgress(new ProgressPart(job.progress(), SHARE, 1));
        PictureFog before = old == null ? null : old.mirrored().fog();
        if (old != null && job.mirrorPlan() == null) {
            return shown.withBounceFog(before).withChangesBounceFog(false);
        }
        PictureFog bounced = bounceFog(before, part.section(1, 2));
        return shown.withBounceFog(bounced).withChangesBounceFog(showsOtherLight(before, bounced));
    }

    private @Nullable PictureFog cameraFog(ProgressPart part) {
        FogMedium medium = FogMedium.of(job.scene());
        PictureFog before = old == null ? null : old.shown().fog();
        return medium == null ? null : build(new FogBuilder(job, job.target(), job.topPlan(), before,
                before != null ? before.rays() : new FogGrid(job.scene().camera(), job.scene().picture()), workers), medium, part);
    }

    private PictureFog build(FogBuilder builder, FogMedium medium, ProgressPart part) {
        FogBuilder.BuiltFog built = builder.build(medium, part);
        shadowRays = shadowRays.plus(built.shadowRays());
        return built.fog();
    }

    private @Nullable PictureFog bounceFog(@Nullable PictureFog before, ProgressPart part) {
        PreparedScene mirrored = job.mirrorTarget();
        FogMedium medium = FogMedium.of(mirrored.scene());
        if (medium == null || before == null && Arrays.stream(mirrored.lights()).allMatch(WeightedLight::isDarkInFog)) {
            return null;
        }
        FogRays rays = bounceRays(before);
        return rays == null ? null
                : build(new FogBuilder(job, mirrored, job.mirrorPlan(), before, rays, workers), medium, part);
    }

    /** Returns the bounced rays, those of the last picture if they are the same; null if no material mirrors or is clear. */
    private @Nullable FogRays bounceRays(@Nullable PictureFog before) {
        PreparedScene mirrored = job.mirrorTarget();
        if (before != null && job.shapeChange().isEmpty() && job.depth() == job.depthBefore() && BounceTracer
                .haveSameBounces(requireNonNull(old).mirroredGeometry().materials(), mirrored.geometry().materials())) {
            return before.rays();
        }
        FogGrid grid = before != null ? before.grid() : new FogGrid(mirrored.scene().camera(), mirrored.scene().picture());
        BounceRays traced = BounceTracer.trace(grid, mirrored.geometry(), mirrored.scene(), workers, job.progress());
        return before != null && traced != null && traced.areSame((BounceRays) before.rays()) ? before.rays() : traced;
    }

    /** Returns whether bounced rays may show other light in fog than before. */
    static boolean showsOtherLight(@Nullable PictureFog before, @Nullable PictureFog now) {
        if (before == null || now == null) {
            return before != now;
        }
        return before.rays() != now.rays() || !before.medium().equals(now.medium())
                || !Arrays.equals(before.lights(), now.lights(), (a, b) -> a == b ? 0 : 1);
    }

    /** Returns the work since the start. */
    WorkCounts work() {
        return new WorkCounts(0, 0, 0, shadowRays);
    }
}
