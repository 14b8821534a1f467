package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import java.util.function.Consumer;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.PictureState.CentersOnly;
import lightning.render.relight.PictureState.Finished;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.CacheBuilder;
import lightning.render.relight.tile.RenderJob;
import lightning.render.relight.tile.WorkCounts;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;

/**
 * Steps from one {@link PictureState} to the next. Each returns the next state and the work it took, and throws if it was canceled or does
 * not fit into memory; the state that it started from stays as it is.
 *
 * @param memoryCheck   absent if pictures are rendered without one, until the paths of their indirect light exceed the memory
 * @param exposure      stops of the display, which decide with its curve when an error of accuracy ratio would be visible
 */
record PictureUpdate(RenderOptions options, WorkerPool workers,
        GeometrySource geometrySource, Optional<MemoryCheck> memoryCheck, double exposure, DisplayCurve curve, Progress progress) {

    /** Next state of a picture, and the work since the first of its steps. */
    record Step(PictureState state, WorkCounts work) {
        static Step start(PictureState state) {
            return new Step(state, WorkCounts.NONE);
        }

        Step then(Step next) {
            return new Step(next.state, work.plus(next.work));
        }
    }

    /** Result of an update: the next state, and what to report. */
    record Outcome(PictureState state, UpdateResult result) {}

    /** Updates a picture to a target scene; leaves out the finer samples if {@code centersOnly}. */
    Outcome run(PictureState from, PlannedUpdate planned, boolean centersOnly) {
        long start = System.nanoTime() - planned.nanoseconds();
        UpdatePlan plan = planned.difference();
        Step step = startFrom(from, planned);
        if (step.state().needsConversion(options.method()) && !(plan instanceof UpdatePlan.FirstPass)) {
            step = step.then(convert(step.state()));
            // Lights and rows are the same, but layers have another accuracy.
            plan = Dispatcher.plan(step.state().picture(), planned.target(), planned.updatesMirrors(), options.method());
        }
        UpdatePlan reported = plan instanceof UpdatePlan.Nothing ? planned.update() : plan;
        step = step.then(updateTo(step.state(), plan, planned.target(), centersOnly));
        UpdatePlan refresh = options.method().refresh(step.state().picture(), exposure, curve);
        if (refresh instanceof UpdatePlan.Relight relight) {
            step = step.then(relight(step.state(), relight, step.state().picture().scene(), false));
        }
        double bound = options.method().errorBound(step.state().picture());
        if (step.state() instanceof CentersOnly unfinished) {
            step = centersOnly ? step.then(defer(unfinished, step.work(), System.nanoTime() - start))
                    : step.then(renderSamples(unfinished, unfinished.samples().plan(unfinished.centers())));
        }
        return new Outcome(step.state(),
                result(reported, step.work(), System.nanoTime() - start, bound, refresh instanceof UpdatePlan.Relight));
    }

    /**
     * Renders the finer samples of a picture.
     *
     * @return all work since the last picture with samples, or since the newest edit if there was none
     */
    Outcome finish(CentersOnly unfinished) {
        long start = System.nanoTime();
        PendingSamples pending = unfinished.samples();
        UpdatePlan plan = pending.plan(unfinished.centers());
        Step step = renderSamples(unfinished, plan);
        WorkCounts work = pending.deferredWork().plus(step.work());
        return new Outcome(step.state(), result(plan, work, pending.nanoseconds() + System.nanoTime() - start, 0, false));
    }

    private static UpdateResult result(UpdatePlan plan, WorkCounts work, long nanoseconds, double bound, boolean refreshed) {
        return new UpdateResult(plan, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(), nanoseconds, bound,
                refreshed);
    }

    /** Goes to the picture that an update was planned from; renders samples that could not follow the update. */
    private Step startFrom(PictureState from, PlannedUpdate planned) {
        if (planned.base() != from.newest()) {
            return Step.start(
                    new Finished(requireNonNull(planned.base()), from instanceof Finished picture ? picture.method() : options.method()));
        }
        return from instanceof CentersOnly unfinished && planned.difference() instanceof UpdatePlan.Relight next
                && !unfinished.samples().canReuseMirrors(unfinished.centers(), next, planned.target())
                        ? renderSamples(unfinished, unfinished.samples().plan(unfinished.centers()))
                        : Step.start(from);
    }

    private Step updateTo(PictureState from, UpdatePlan plan, Scene target, boolean centersOnly) {
        return switch (plan) {
            case UpdatePlan.Nothing _ -> Step.start(from);
            case UpdatePlan.FirstPass first -> firstPass(from, first, target, centersOnly && canDeferSamples(target));
            case UpdatePlan.Relight relight -> relight(from, relight, target,
                    (centersOnly || from instanceof CentersOnly) && !relight.resampled() && canDeferSamples(target));
        };
    }

    /** Records work as deferred; it is reported again with the samples. */
    private static Step defer(CentersOnly unfinished, WorkCounts work, long nanoseconds) {
        return Step.start(new CentersOnly(unfinished.centers(), unfinished.samples().plus(work, nanoseconds)));
    }

    /** Scaled contributions are off by the loss of all their scalings, and centers and samples must be off by the same. */
    boolean canDeferSamples(Scene target) {
        return options.method().isExact() && RenderJob.needsEdges(target);
    }

    private Step convert(PictureState from) {
        CacheConversion.Result result = new CacheConversion(from.picture(), options).run(workers, progress);
        return new Step(new Finished(result.cache(), options.method()), result.work());
    }

    /**
     * Rejects a picture that does not fit into memory; may render small pictures to find out.
     *
     * @param reservedBytes bytes in use next to it
     * @param previews      receives these pictures
     */
    void checkMemory(Scene target, long reservedBytes, boolean centersOnly, Consumer<Film> previews) {
        memoryCheck.ifPresent(check -> check.requirePicture(target, options.withMemory(options.memory() - reservedBytes),
                centersOnly ? PictureParts.CENTERS : PictureParts.ALL,
                new SmallPictures(geometrySource.shared(), progress.cancellationOnly(), previews)));
    }

    private Step firstPass(PictureState from, UpdatePlan.FirstPass plan, Scene target, boolean centersOnly) {
        checkMemory(target, from.bytes(), centersOnly, _ -> {});
        RenderJob job = RenderJob.firstPass(geometrySource.get(target, from.newest(), options.view()), target, options, progress);
        CacheBuilder.BuildResult result = CacheBuilder.build(job, workers, null, centersOnly);
        return new Step(centersOnly ? new CentersOnly(result.cache(), new PendingSamples(null, plan)) : finished(result), result.work());
    }

    private Step relight(PictureState from, UpdatePlan.Relight plan, Scene target, boolean centersOnly) {
        PixelCache old = from.picture();
        if (plan.resampled() && RenderJob.needsEdges(target)) {
            checkSampleMemory(target, old, options.memory() - (from.bytes() - old.centerBytes() - old.indirectBytes()));
        }
        var scenes = new RenderedScenes(target, plan.mirrors() == null ? old.mirrored().scene() : target);
        RenderJob job = RenderJob.relight(plan, old, plan.shapes().after(old.geometry()), scenes, options, progress);
        // Where only weights change, samples take no longer than centers.
        boolean defers = centersOnly && !(from instanceof Finished && job.keepsSamples());
        CacheBuilder.BuildResult result = CacheBuilder.build(job, workers, old, defers);
        return new Step(defers ? new CentersOnly(result.cache(), samplesAfter(from, plan)) : finished(result), result.work());
    }

    private static PendingSamples samplesAfter(PictureState from, UpdatePlan.Relight plan) {
        return from instanceof CentersOnly unfinished ? unfinished.samples().afterUpdate(plan) : new PendingSamples(from.newest(), plan);
    }

    private Finished finished(CacheBuilder.BuildResult result) {
        return new Finished(result.cache(), options.method());
    }

    /** @param memory bytes that are free for centers and samples */
    private void checkSampleMemory(Scene target, PixelCache centers, long memory) {
        memoryCheck.ifPresent(check -> check.requireSamples(target, centers, options.withMemory(memory),
                new SmallPictures(centers.geometry(), progress.cancellationOnly(), _ -> {})));
    }

    /** Renders the finer samples of centers. */
    private Step renderSamples(CentersOnly unfinished, UpdatePlan plan) {
        PixelCache centers = unfinished.centers();
        PixelCache finished = unfinished.samples().finishedCache();
        if (finished == null) {
            checkSampleMemory(centers.scene(), centers, options.memory());
        }
        CacheBuilder.BuildResult result = finished != null && plan instanceof UpdatePlan.Relight relight
                ? CacheBuilder.finish(RenderJob.relight(relight, finished, centers.geometry(), centers.scenes(), options, progress),
                        workers,
                        finished,
                        centers)
                : CacheBuilder.finish(RenderJob.samples(centers, options, progress), workers, null, centers);
        return new Step(finished(result), result.work());
    }
}
