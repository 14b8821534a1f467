package lightning.document.loop;

import static java.util.Objects.requireNonNull;

import java.lang.ref.WeakReference;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import lightning.render.RenderOptions;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.PlannedUpdate;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RenderedScenes;
import lightning.render.warmup.DelayedLanes;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Runs the jobs of a {@link RenderLoop} with a renderer, on the loop's thread. Other threads only set the display mode. */
final class RenderWorker implements RenderJobRunner.RenderJobHandler {
    private final RenderListener listener;
    private final RenderQueue queue;
    private final PictureVerifier verifier;
    private final Renderer renderer;
    private final DisplayRenderer displayRenderer = new DisplayRenderer();
    private volatile ViewTransform view = ViewTransform.DEFAULT;
    private volatile DisplayMode displayMode = DisplayMode.FULL_PICTURE;
    /** Startup preview of the first scene; null afterwards. */
    private volatile Future<Optional<CoarsePicture>> startupPreview = CompletableFuture.completedFuture(Optional.empty());
    /** Event that the rest of the first pass waits for. */
    private volatile Future<?> menusShown = CompletableFuture.completedFuture(null);
    private @Nullable UpdateResult lastUpdate;
    /** Step of the image. */
    private Frame.@Nullable Step lastStep;
    private @Nullable UpdateMethod lastMethod;
    private @Nullable Scene renderedScene;
    /** Description of the last update if it was slow; else empty. Written by the thread that finds out. */
    private volatile String slowUpdate = "";
    private final EditPreview editPreview;
    private final PathTimes pathTimes;
    /** Cache of the last picture with indirect light while one without it is shown, to keep its paths; otherwise null. */
    private @Nullable PixelCache pathsCache;
    /** Cache of the last reported image, weakly referenced so that readers do not keep it in memory. */
    private volatile WeakReference<PixelCache> publishedCache = new WeakReference<>(null);

    private final PictureKeeper keeper;

    RenderWorker(RenderOptions options, RenderQueue queue, PictureVerifier verifier, RenderListener listener, PathTimes pathTimes,
            KeptPictures kept) {
        this.pathTimes = pathTimes;
        keeper = new PictureKeeper(kept);
        renderer = new Renderer(options);
        editPreview = new EditPreview(renderer);
        this.queue = queue;
        this.verifier = verifier;
        this.listener = listener;
    }

    /** Sets the startup preview, as {@link RenderLoop#setStartupPreview}. */
    void setStartupPreview(Future<Optional<CoarsePicture>> preview, Future<?> menus) {
        startupPreview = preview;
        menusShown = menus;
    }

    void setView(ViewTransform v) {
        view = v;
    }

    void setDisplayMode(DisplayMode v) {
        displayMode = v;
    }

    /** Returns the cache, as {@link RenderLoop#cache}. */
    Optional<PixelCache> cache() {
        return Optional.ofNullable(publishedCache.get());
    }

    @Override
    public void handle(RenderQueue.Job job, RenderQueue.CancelSignal signal) {
        verifier.stopIdleWork();
        switch (job) {
            case RenderQueue.Job.Render r -> renderScene(r.scene(), signal);
            case RenderQueue.Job.ChangeOptions r -> changeOptions(r, signal);
            case RenderQueue.Job.UpdateReflections _ -> updateReflections(signal);
            case RenderQueue.Job.Redisplay _ -> redisplay(signal);
            case RenderQueue.Job.RenderSamples _ -> renderSamples(signal);
            case RenderQueue.Job.Verify _ -> startVerification(signal);
            case RenderQueue.Job.DropPicture f -> dropDocument(f);
            case RenderQueue.Job.KeepPicture _ -> keeper.keep(renderer);
        }
    }

    @Override
    public @Nullable Scene renderedScene() {
        return renderedScene;
    }

    @Override
    public void becomeIdle() {
        if (renderedScene != null && renderer.state().isFinished()) {
            PixelCache picture = renderer.cache();
            verifier.startIdleWork(picture, renderer.options(), progress -> editPreview.prepareLit(picture, progress));
        }
    }

    private void changeOptions(RenderQueue.Job.ChangeOptions job, RenderQueue.CancelSignal signal) {
        renderer.setOptions(job.options());
        pathsCache = null;
        if (!renderer.state().hasPicture()) {
            dropPicture();
        }
        if (job.scene() != null) {
            renderScene(job.scene(), signal);
        }
    }

    private void renderScene(Scene scene, RenderQueue.CancelSignal signal) {
        keeper.restore(scene, renderer, () -> result(menusShown));
        PlannedUpdate planned = renderer.plan(scene);
        listener.started(planned.update());
        boolean isSeparable = canShowDirectLightAlone(scene);
        boolean adds = isSeparable && addsIndirectLight(scene, planned.update());
        boolean repeats = isSeparable && !adds && repeatsPaths(planned.update());
        if (!adds || renderer.state().hasPicture() && renderer.cache().indirect() != null) {
            pathsCache = null;
        }
        if (repeats && pathTimes.areSlow() && canKeepPicture()) {
            pathsCache = renderer.cache();
        }
        if (adds || pathsCache != null) {
            renderDirectFirst(scene, signal);
        } else {
            double seconds = renderStep(scene, scene, planned, Frame.Step.ALL_LIGHT, signal);
            if (repeats) {
                pathTimes.recordUpdate(seconds);
            }
        }
        if (!renderer.state().isFinished()) {
            queue.requestSamples();
        }
        if (keeper.isNew()) {
            queue.requestKeeping();
        }
    }

    /**
     * @param requested scene that the display waits for
     * @param scene     scene of this step: the same, or without its indirect light
     * @return time in seconds
     */
    private double renderStep(Scene requested, Scene scene, PlannedUpdate planned, Frame.Step step, RenderQueue.CancelSignal signal) {
        boolean isFirst = planned.update() instanceof UpdatePlan.FirstPass;
        ProgressiveDisplay display = isFirst ? startFirstPass(requested, scene, signal) : startUpdate(requested, scene, planned, signal);
        long start = System.nanoTime();
        try (var _ = isFirst ? new DelayedLanes() : null) {
            update((r, _) -> r.renderCenters(planned, display), step, startCache(), (r, progress) -> r.render(scene, progress), signal);
        }
        long nanoseconds = System.nanoTime() - start;
        // Showing coarse images and tiles takes time, too, and must not keep an update slow that is fast without them.
        if (nanoseconds - display.displayNs() / renderer.options().threads() < ProgressiveDisplay.SLOW_NS) {
            slowUpdate = "";
        }
        return nanoseconds / 1e9;
    }

    /** Returns whether direct light can be shown first: it needs no paths, and indirect light does. */
    private static boolean canShowDirectLightAlone(Scene scene) {
        return scene.picture().indirect().isPresent() && GatherSettings.of(scene.withoutIndirect()).isEmpty();
    }

    /** Returns whether an update traces paths of indirect light again because objects changed, with mirrors that show them too. */
    private static boolean repeatsPaths(UpdatePlan update) {
        return tracesPaths(update) && update instanceof UpdatePlan.Relight relight && relight.mirrors() != null;
    }

    private static boolean tracesPaths(UpdatePlan update) {
        return update instanceof UpdatePlan.Relight relight && relight.paths() == PathUpdate.REPEAT;
    }

    /** Returns whether the image has all samples, and there is memory for a direct and a new one even if they share nothing with it. */
    private boolean canKeepPicture() {
        return renderer.state().isFinished() && 3 * renderer.state().bytes() <= renderer.options().memory();
    }

    /** Returns whether an update traces the paths of indirect light, and the image without it can be kept. */
    private boolean addsIndirectLight(Scene scene, UpdatePlan update) {
        Scene shown = renderer.options().view().apply(scene);
        if (shown.picture().indirect().isEmpty()) {
            return false;
        }
        PixelCache cache = renderer.state().hasPicture() ? renderer.cache() : null;
        return update instanceof UpdatePlan.FirstPass || cache == null || cache.indirect() == null
                || !shown.picture().indirect().equals(cache.scene().picture().indirect())
                        && shown.withoutIndirect().equals(cache.scene().withoutIndirect());
    }

    /**
     * Renders the scene without indirect light, shows it, and adds indirect light. A newer scene replaces the second step, so that each
     * scene of a drag is shown with direct light. A canceled second step leaves the image of the first. After an edit of objects the
     * second step starts from the image before it, which has paths to keep.
     */
    private void renderDirectFirst(Scene scene, RenderQueue.CancelSignal signal) {
        Scene direct = scene.withoutIndirect();
        boolean isShown = renderer.state().hasPicture()
                && renderer.scene().withoutIndirect().equals(renderer.options().view().apply(direct));
        double directSeconds = 0;
        if (!isShown) {
            directSeconds = renderStep(scene, direct, renderer.plan(direct), Frame.Step.DIRECT_LIGHT, signal);
        } else {
            renderer.requireMemory(scene, 0, signal, _ -> {});
        }
        listener.indirectStarted();
        queue.setReplaceable(signal, true);
        PlannedUpdate planned = renderer.planFrom(pathsCache, scene);
        long start = System.nanoTime();
        update((r, progress) -> r.renderCenters(planned, progress), Frame.Step.INDIRECT_LIGHT, pathsCache,
                pathsCache == null ? null : (r, progress) -> r.render(scene, progress), signal);
        double seconds = (System.nanoTime() - start) / 1e9;
        if (repeatsPaths(planned.update())) {
            pathTimes.recordSteps(directSeconds, seconds);
        } else {
            pathTimes.recordBuild(seconds);
        }
        pathsCache = null;
    }

    /** Shows the first coarse images, makes sure that the scene fits into memory, and shows further ones. */
    private ProgressiveDisplay startFirstPass(Scene requested, Scene scene, RenderQueue.CancelSignal signal) {
        CoarsePass coarse = new CoarsePass(RenderedScenes.of(scene), renderer::prepare, renderer.options(),
                film -> listener.coarseRendered(film, requested), signal);
        takeStartupPreview().filter(preview -> preview.shows(requested)).ifPresent(preview -> {
            renderer.setSharedGeometry(preview.geometry());
            coarse.show(preview);
            result(menusShown);
        });
        boolean canShow = CoarsePicture.isFilmPossible(scene, renderer.options());
        if (canShow) {
            queue.setReplaceable(signal, coarse.isShown());
            coarse.showFirst(editPreview.speed());
        }
        queue.setReplaceable(signal, coarse.isShown());
        freeMemory(requested, signal, canShow && scene == requested ? coarse::offerLit : _ -> {});
        coarse.last().ifPresent(picture -> renderer.setSharedGeometry(picture.geometry()));
        coarse.showRest();
        editPreview.setSpeed(coarse.pixelsPerSecond());
        return new ProgressiveDisplay(signal, requested, listener, () -> {}, canReplace -> queue.setReplaceable(signal, canReplace), true)
                .showingTiles(coarse.isShown())
                .keepingWork(new WaitingScenePreview(requested, coarse.pixelsPerSecond() / renderer.options().threads(), signal));
    }

    /** Shows a coarse image of a scene that waits for a first pass, on the thread of a tile. */
    private final class WaitingScenePreview implements ProgressiveDisplay.WaitingScene {
        /** Time for the image, in seconds. */
        private static final double SECONDS = 0.5;

        private final Scene running;
        private final double pixelsPerSecond;
        private final RenderQueue.CancelSignal signal;
        private final AtomicBoolean isTracing = new AtomicBoolean();
        private volatile @Nullable Scene shown;

        WaitingScenePreview(Scene running, double pixelsPerSecond, RenderQueue.CancelSignal signal) {
            this.running = running;
            this.pixelsPerSecond = pixelsPerSecond;
            this.signal = signal;
        }

        @Override
        public boolean show() {
            Scene waiting = queue.waitingScene(running);
            if (waiting == null || waiting == shown || waiting == running || !isTracing.compareAndSet(false, true)) {
                return false;
            }
            try {
                int pixels = CoarseSteps.of(waiting).during(SECONDS, pixelsPerSecond);
                listener.coarseRendered(CoarsePicture.trace(RenderedScenes.of(waiting), pixels, renderer::geometryOf, 1, signal).film(),
                        waiting);
                shown = waiting;
                return true;
            } finally {
                isTracing.set(false);
            }
        }
    }

    /** Shows a coarse image if the last update of this kind was slow, and prepares to show one if this update turns out to be slow. */
    private ProgressiveDisplay startUpdate(Scene requested, Scene scene, PlannedUpdate planned, RenderQueue.CancelSignal signal) {
        String kind = planned.update().description();
        var scenes = new RenderedScenes(scene,
                renderer.options().keepsReflectionsCurrent() ? scene : renderer.cache().mirrored().scene());
        boolean canShow = displayMode.isFullPicture() && CoarseSteps.of(scene).first() > 0;
        EditPreview.Before before = editPreview.before();
        var display = new ProgressiveDisplay(signal, requested, listener, () -> {
            slowUpdate = kind;
            if (canShow) {
                listener.coarseRendered(editPreview.trace(before, scenes, 1, signal), requested);
            }
        }, canReplace -> queue.setReplaceable(signal, canReplace), canShow);
        boolean isLit = canShow && tracesPaths(planned.update()) && editPreview.canBeLit(before, scenes);
        if (isLit || canShow && kind.equals(slowUpdate)) {
            Optional<Film> lit = isLit ? editPreview.traceLit(before, scenes, signal) : Optional.empty();
            listener.coarseRendered(lit.orElseGet(() -> editPreview.trace(before, scenes, renderer.options().threads(), signal)),
                    requested);
            queue.setReplaceable(signal, true);
            display.showingTiles(true);
        }
        return display;
    }

    /** Renders the missing samples of the image, if any. */
    private void renderSamples(RenderQueue.CancelSignal signal) {
        if (!renderer.state().isFinished()) {
            Scene scene = renderer.scene();
            listener.samplesStarted();
            var display = new ProgressiveDisplay(signal, scene, listener, () -> {}, _ -> {}, displayMode.isFullPicture());
            if (renderer.state().lastFinished() == null) {
                display.showingTiles(false);
            }
            update((r, _) -> r.finish(display), requireNonNull(lastStep), startCache(), (r, progress) -> r.render(scene, progress), signal);
        }
    }

    /**
     * Frees the current image if a new one does not fit into memory with it. A canceled pass then cannot restore it.
     *
     * @param previews receives small images of the scene, if the memory is estimated by them
     * @throws PictureTooLargeException if it does not fit at all; nothing is freed then
     */
    private void freeMemory(Scene scene, RenderQueue.CancelSignal signal, Consumer<Film> previews) {
        renderer.requireMemory(scene, 0, signal, previews);
        long usedBytes = renderer.state().bytes() + displayRenderer.bytes();
        try {
            renderer.requireMemory(scene, usedBytes, signal, previews);
        } catch (PictureTooLargeException e) {
            dropPicture();
        }
    }

    private void dropPicture() {
        renderer.clear();
        editPreview.clear();
        pathsCache = null;
        displayRenderer.close();
        publishedCache = new WeakReference<>(null);
        renderedScene = null;
        lastUpdate = null;
        verifier.setLastEdit(Optional.empty());
    }

    /**
     * Updates the image.
     *
     * @param result     step of the rendering that the image is then the result of
     * @param start      cache that the update starts from; null if unknown
     * @param repeatStep repeats the update from the start, planning included, to measure its saving; null if its saving is not measured
     */
    private void update(WarmSaving.UpdateStep step, Frame.Step result, @Nullable PixelCache start,
            WarmSaving.@Nullable UpdateStep repeatStep, RenderQueue.CancelSignal signal) {
        ViewTransform usedView = view;
        renderer.setView(usedView.exposure(), usedView.steepestCurve());
        UpdateResult update = step.run(renderer, signal);
        verifier.setLastEdit(!renderer.state().isFinished() || repeatStep == null ? Optional.empty()
                : WarmSaving.RepeatableEdit.of(update, start, renderer.options(), (r, progress) -> {
                    r.setView(usedView.exposure(), usedView.steepestCurve());
                    return repeatStep.run(r, progress);
                }));
        lastMethod = renderer.options().method();
        lastStep = result;
        show(update, signal);
    }

    /** Returns the cache that the update starts from; null if a repetition cannot start from it, as its method differs. */
    private @Nullable PixelCache startCache() {
        return renderer.state().hasPicture() && renderer.options().method().equals(lastMethod) ? renderer.state().lastFinished() : null;
    }

    private void dropDocument(RenderQueue.Job.DropPicture job) {
        if (job.keepsFirst()) {
            keeper.keep(renderer);
        }
        dropPicture();
        verifier.openDocument();
        keeper.open();
        listener.pictureDropped(job.number());
    }

    private void updateReflections(RenderQueue.CancelSignal signal) {
        if (renderedScene != null && !renderer.cache().hasCurrentReflections()) {
            update(Renderer::updateReflections, requireNonNull(lastStep), startCache(), Renderer::updateReflections, signal);
        }
    }

    private void redisplay(RenderQueue.CancelSignal signal) {
        if (renderedScene != null) {
            show(lastUpdate, signal);
        }
    }

    private void show(@Nullable UpdateResult update, RenderQueue.CancelSignal signal) {
        renderedScene = renderer.scene();
        lastUpdate = update;
        DisplayMode mode = displayMode;
        try {
            publish(mode.isFullPicture() ? displayRenderer.fullPicture(renderer)
                    : displayRenderer.film(renderer, mode, signal.cancellationOnly()), mode);
        } catch (CancellationException e) {
            // The image itself is finished.
            publish(renderer.film(), DisplayMode.FULL_PICTURE);
        } catch (PictureTooLargeException | OutOfMemoryError e) {
            publish(displayRenderer.fullPicture(renderer), DisplayMode.FULL_PICTURE);
            throw e;
        }
    }

    private void publish(Film displayed, DisplayMode mode) {
        publishedCache = new WeakReference<>(renderer.cache());
        IndirectCache indirect = renderer.cache().indirect();
        listener.rendered(new Frame(renderer.film(), displayed, mode, requireNonNull(renderedScene), renderer.cache().mirrored().scene(),
                requireNonNull(lastUpdate),
                renderer.cache().geometry(), indirect == null ? null : indirect.light(), requireNonNull(lastStep),
                renderer.state().isFinished()));
    }

    private Optional<CoarsePicture> takeStartupPreview() {
        Optional<CoarsePicture> preview = result(startupPreview);
        startupPreview = CompletableFuture.completedFuture(Optional.empty());
        return preview == null ? Optional.empty() : preview;
    }

    /** Waits for a result; null if there is none. */
    private static <T> @Nullable T result(Future<T> future) {
        try {
            return future.get();
        } catch (ExecutionException | CancellationException e) {
            return null;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return null;
        }
    }

    private void startVerification(RenderQueue.CancelSignal signal) {
        if (renderedScene != null) {
            renderSamples(signal);
            verifier.verify(AccuracyGuarantee.of(renderer, requireNonNull(lastUpdate)), renderer.film().copy(), signal);
        }
    }

    @Override
    public void close() {
        keeper.close();
        editPreview.close();
        renderer.close();
        displayRenderer.close();
    }
}
