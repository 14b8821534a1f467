package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.ContributionScene;
import lightning.render.relight.FilmError;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.RayCounts;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.render.trace.Geometry;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RenderLoopTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1);

    private final RecordingRenderListener listener = new RecordingRenderListener();
    private final RenderLoop loop = new RenderLoop(OPTIONS, listener);
    private final Scene scene = DeskScene.scene();

    @AfterEach
    void close() {
        loop.close();
    }

    private Scene key(double intensity) {
        return DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", intensity));
    }

    private static Film reference(Scene scene) {
        return new ReferenceTracer(scene).trace();
    }

    private static Film stale(Scene scene, Scene mirrored) {
        try (var workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene, mirrored, Geometry.of(scene)).trace(workers, Progress.NONE).film();
        }
    }

    private RecordingRenderListener.Shown go(Scene requested) throws InterruptedException {
        loop.render(requested);
        return awaitFinished();
    }

    /** Waits for the next image with all its samples. */
    private RecordingRenderListener.Shown awaitFinished() throws InterruptedException {
        RecordingRenderListener.Shown shown = listener.next(RecordingRenderListener.Shown.class);
        while (!shown.frame().isFinished()) {
            shown = listener.next(RecordingRenderListener.Shown.class);
        }
        return shown;
    }

    /** Returns a scene large enough for a coarse preview. */
    private Scene large() {
        return scene.withPicture(scene.picture().withSize(240, 160));
    }

    /** Returns the width of the first reported coarse image. */
    private int renderWithPreview(Scene requested, Future<Optional<CoarsePicture>> preview) throws Exception {
        loop.setStartupPreview(preview, CompletableFuture.completedFuture(null));
        loop.render(requested);
        Film seen = listener.next(RecordingRenderListener.Coarse.class).film();
        awaitFinished();
        return seen.width();
    }

    private static Future<Optional<CoarsePicture>> previewOf(Scene of) {
        return CompletableFuture.completedFuture(Optional.of(new CoarsePicture(of, Geometry.of(of), Film.black(3, 2), Double.MAX_VALUE)));
    }

    @Test
    void startupPreview_isReused() throws Exception {
        Scene wanted = large();
        assertThat(renderWithPreview(wanted, previewOf(wanted))).isEqualTo(3);
    }

    @Test
    void startupPreviewOfOtherScene_isIgnored() throws Exception {
        Scene other = large();
        assertThat(renderWithPreview(large(), previewOf(other.withWorld(other.world().withAmbience(0.5))))).isGreaterThan(3);
    }

    @Test
    void failedStartupPreview_isRenderedByLoop() throws Exception {
        assertThat(renderWithPreview(large(), CompletableFuture.failedFuture(new OutOfMemoryError()))).isGreaterThan(3);
    }

    @Test
    void tooLargePicture_hasNoPreview() {
        Scene huge = scene.withPicture(scene.picture().withSize(16_384, 16_384));
        assertThat(CoarsePicture.first(huge, OPTIONS.withMemory(1 << 20), _ -> {})).isEmpty();
    }

    @Test
    void firstPicture_equalsReference() throws Exception {
        RecordingRenderListener.Shown shown = go(scene);
        assertThat(shown.film().hasSameBits(reference(scene))).isTrue();
        assertThat(shown.frame().scene()).isEqualTo(scene);
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.FirstPass.class);
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void reportedPlan_isExecuted() throws Exception {
        go(scene);
        listener.events.clear();
        loop.render(key(0.3));
        UpdatePlan told = listener.next(RecordingRenderListener.Started.class).plan();
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().update().plan()).isSameAs(told);
    }

    private static Scene sized(Scene scene, int width, int height) {
        return scene.withPicture(scene.picture().withSize(width, height));
    }

    /** Returns a loop with a memory limit. */
    private RenderLoop loopWithMemory(long memory) {
        return new RenderLoop(OPTIONS.withMemory(memory), listener);
    }

    @Test
    void tooLargePicture_isRejectedBeforeTracing() throws Exception {
        try (RenderLoop small = loopWithMemory(50_000_000)) {
            small.render(sized(scene, 2048, 2048));
            assertThat(listener.events.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isInstanceOf(RecordingRenderListener.Started.class);
            assertThat(listener.events.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isInstanceOf(PictureTooLargeException.class);
        }
    }

    @Test
    void pictureFittingOnlyAlone_replacesPreviousPicture() throws Exception {
        Scene first = sized(scene, 256, 192);
        Scene second = sized(scene, 256, 191);
        long each;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(first, Progress.NONE);
            each = MemoryEstimate.usedBytes(renderer.cache());
        }
        try (RenderLoop small = loopWithMemory(each * 3 / 2)) {
            small.render(first);
            listener.next(RecordingRenderListener.Shown.class);
            small.render(second);
            assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene()).isEqualTo(second);
        }
    }

    @Test
    void effectRenderTooLarge_isReportedAndPictureIsShown() throws Exception {
        Scene first = sized(scene, 256, 192);
        long each;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(first, Progress.NONE);
            each = MemoryEstimate.usedBytes(renderer.cache());
        }
        try (RenderLoop small = loopWithMemory(each * 5 / 4)) {
            small.setDisplayMode(DisplayMode.FULL_PICTURE.withEffects(ViewEffects.ALL.with(RenderEffect.SPECULAR, false)));
            small.render(first);
            RecordingRenderListener.Shown shown = listener.next(RecordingRenderListener.Shown.class);
            assertThat(shown.frame().displayMode()).isEqualTo(DisplayMode.FULL_PICTURE);
            assertThat(shown.frame().displayed().hasSameBits(reference(first))).isTrue();
            listener.next(PictureTooLargeException.class);
        }
    }

    @Test
    void edit_updatesWithStaleMirrors() throws Exception {
        go(scene);
        RecordingRenderListener.Shown shown = go(key(2));
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(shown.film().hasSameBits(stale(key(2), scene))).isTrue();
        assertThat(shown.frame().mirrorsAreCurrent()).isFalse();
    }

    @Test
    void updateReflections_equalsReference() throws Exception {
        go(scene);
        go(key(2));
        loop.updateReflections();
        RecordingRenderListener.Shown shown = listener.next(RecordingRenderListener.Shown.class);
        assertThat(shown.film().hasSameBits(reference(key(2)))).isTrue();
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void job_isFollowedByIdle() throws Exception {
        go(scene);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        assertThat(loop.isBusy()).isFalse();
    }

    @Test
    void editsWhileRendering_renderOnlyNewest() throws Exception {
        go(scene);
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        assertThat(loop.isBusy()).isTrue();
        loop.render(key(3));
        loop.render(key(4));
        hold.release();
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene()).isEqualTo(key(2));
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene()).isEqualTo(key(4));
    }

    @Test
    void newSizeWhileTracing_cancelsTrace() throws Exception {
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(scene.withPicture(scene.picture().withSize(200, 200)));
        hold.awaitReached();
        loop.render(scene);
        hold.release();
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene()).isEqualTo(scene);
    }

    @Test
    void editDuringMirrorUpdate_isRenderedBeforeMirrors() throws Exception {
        go(scene);
        go(key(2));
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.updateReflections();
        hold.awaitReached();
        loop.render(key(3));
        hold.release();
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().mirroredScene()).isEqualTo(scene);
        assertThat(listener.next(RecordingRenderListener.Shown.class).film().hasSameBits(reference(key(3)))).isTrue();
    }

    @Test
    void cancel_keepsLastPictureAndDropsPendingJobs() throws Exception {
        go(scene);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        loop.render(key(3));
        loop.updateReflections();
        loop.cancel();
        hold.release();
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        assertThat(loop.isBusy()).isFalse();
        RecordingRenderListener.Shown shown = go(key(4));
        assertThat(shown.film().hasSameBits(stale(key(4), scene))).isTrue();
    }

    @Test
    void undoneEdit_castsNoRay() throws Exception {
        go(scene);
        assertThat(go(scene).frame().update().plan()).isInstanceOf(UpdatePlan.Nothing.class);
    }

    @Test
    void verificationOfCurrentMirrors_findsNoDifference() throws Exception {
        go(scene);
        loop.verify();
        Verification verification = listener.next(Verification.class);
        assertThat(verification.currentDifference().isNone()).isTrue();
        assertThat(verification.full().hasSameBits(reference(scene))).isTrue();
    }

    @Test
    void verificationOfStaleMirrors_passesAndShowsDifference() throws Exception {
        go(scene);
        go(key(5));
        loop.verify();
        Verification verification = listener.next(Verification.class);
        assertThat(verification.currentDifference().isNone()).isFalse();
        assertThat(verification.expectedDifference().isNone()).isTrue();
        assertThat(verification.guarantee().scenes().scene()).isEqualTo(key(5));
    }

    private Scene sized(int width, int height) {
        return scene.withPicture(scene.picture().withSize(width, height));
    }

    @Test
    @Slow
    void edit_isFollowedByItsSaving() throws Exception {
        go(scene);
        for (int i = 1; i < 3; i++) {
            Frame frame = go(key(i + 1)).frame();
            assertThat(listener.next(WarmSaving.class).isOf(frame.update())).isTrue();
        }
        loop.updateReflections();
        Frame mirrored = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(listener.next(WarmSaving.class).isOf(mirrored.update())).isTrue();
    }

    @Test
    @Slow
    void firstPictureAndNewAccuracy_haveNoSaving() throws Exception {
        go(scene);
        go(sized(50, 40));
        loop.changeOptions(OPTIONS.withAccuracy(Accuracy.RATIO));
        UpdateResult converted = listener.next(RecordingRenderListener.Shown.class).frame().update();
        Scene brighter = sized(50, 40).withLight(DeskScene.light(scene, "key").withIntensity(2));
        UpdateResult edited = go(brighter).frame().update();
        WarmSaving first = listener.next(WarmSaving.class);
        assertThat(first.isOf(converted)).isFalse();
        assertThat(first.isOf(edited)).isTrue();
    }

    @Test
    @Slow
    void jobWhileMeasuring_isNotDelayedAndNewestEditIsMeasured() throws Exception {
        go(sized(400, 300));
        Scene brighter = sized(400, 300).withLight(DeskScene.light(scene, "key").withIntensity(2));
        go(brighter);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        UpdateResult newer = go(brighter.withLight(DeskScene.light(scene, "key").withIntensity(3))).frame().update();
        assertThat(listener.next(WarmSaving.class).isOf(newer)).isTrue();
    }

    @Test
    @Slow
    void verificationWhileMeasuring_restartsMeasurement() throws Exception {
        go(scene);
        UpdateResult update = go(key(2)).frame().update();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        loop.verify();
        listener.next(Verification.class);
        assertThat(listener.next(WarmSaving.class).isOf(update)).isTrue();
    }

    private static Film unmirroredShare(Scene shown) {
        return new ReferenceTracer(ContributionScene.of(shown.withPicture(shown.picture().withDepth(0)), "key")).trace();
    }

    @Test
    void singleLightMode_showsItsShareAndKeepsPicture() throws Exception {
        go(scene);
        go(key(2));
        loop.setDisplayMode(DisplayMode.FULL_PICTURE.withLight(Optional.of("key")));
        Frame frame = listener.next(RecordingRenderListener.Shown.class).frame();
        // Mirrors show an earlier scene, which belongs to no light.
        assertThat(frame.displayed().hasSameBits(unmirroredShare(key(2)))).isTrue();
        assertThat(frame.film().hasSameBits(stale(key(2), scene))).isTrue();
        assertThat(frame.displayMode().label()).isEqualTo("Only key");
        loop.verify();
        assertThat(listener.next(Verification.class).expectedDifference().isNone()).isTrue();
        assertThat(go(key(3)).frame().displayed().hasSameBits(unmirroredShare(key(3)))).isTrue();
        loop.setDisplayMode(DisplayMode.FULL_PICTURE);
        frame = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(frame.displayed().hasSameBits(frame.film())).isTrue();
    }

    @Test
    void hiddenEffects_areMissingOnlyInDisplay() throws Exception {
        go(scene);
        go(key(2));
        ViewEffects dull = ViewEffects.ALL.withHidden(Set.of(RenderEffect.SHADOWS, RenderEffect.REFLECTION));
        loop.setDisplayMode(DisplayMode.FULL_PICTURE.withEffects(dull));
        Frame frame = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(frame.displayed().hasSameBits(referenceWithEffects(dull, key(2)))).isTrue();
        assertThat(frame.film().hasSameBits(stale(key(2), scene))).isTrue();
        assertThat(frame.displayMode().label()).isEqualTo("No shadows, no reflections");
        assertThat(go(key(3)).frame().displayed().hasSameBits(referenceWithEffects(dull, key(3)))).isTrue();
    }

    private static Film referenceWithEffects(ViewEffects effects, Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS.withView(effects))) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    @Test
    void hiddenShadows_keepMirrorsStale() throws Exception {
        go(scene);
        go(key(2));
        loop.setDisplayMode(DisplayMode.FULL_PICTURE.withEffects(ViewEffects.ALL.withLitTextures(false)));
        Frame frame = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(frame.displayed().hasSameBits(stale(key(2), scene))).as("no textures").isTrue();
    }

    @Test
    void noPicture_mirrorsAndVerificationDoNothing() throws Exception {
        loop.updateReflections();
        loop.verify();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        go(scene);
        assertThat(listener.events).noneMatch(e -> e instanceof Verification || e instanceof Throwable);
    }

    @Test
    void newAccuracy_keepsCache() throws Exception {
        go(scene);
        go(key(2));
        loop.changeOptions(OPTIONS.withAccuracy(Accuracy.RATIO));
        RecordingRenderListener.Shown shown = listener.next(RecordingRenderListener.Shown.class);
        assertThat(shown.frame().scene()).isEqualTo(key(2));
        assertThat(shown.frame().update().rays()).isEqualTo(RayCounts.NONE);
        loop.changeOptions(OPTIONS.withReflections(ReflectionMode.CURRENT));
        shown = listener.next(RecordingRenderListener.Shown.class);
        assertThat(shown.frame().update().rays()).isEqualTo(RayCounts.NONE);
        assertThat(shown.film().hasSameBits(reference(key(2)))).isTrue();
        assertThat(go(key(3)).film().hasSameBits(reference(key(3)))).isTrue();
    }

    @Test
    void accuracyAndScene_areOneUpdate() throws Exception {
        go(scene);
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        loop.changeOptions(OPTIONS.withAccuracy(Accuracy.RATIO));
        loop.render(key(3));
        hold.release();
        listener.next(RecordingRenderListener.Shown.class);
        RecordingRenderListener.Shown shown = listener.next(RecordingRenderListener.Shown.class);
        assertThat(shown.frame().scene()).isEqualTo(key(3));
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(shown.frame().update().rays()).isEqualTo(RayCounts.NONE);
    }

    private void assertTilesEqual(Film film) {
        assertThat(listener.tiles).hasSize(film.tileCount());
        assertThat(listener.tiles).allSatisfy(
                (tile, rgb) -> assertThat(rgb).isDeepEqualTo(new float[][] {film.red(tile), film.green(tile), film.blue(tile)}));
    }

    @ParameterizedTest
    @EnumSource(AntialiasMode.class)
    void firstPassTiles_areReportedBeforePicture(AntialiasMode antialias) throws Exception {
        Scene sampled = scene.withPicture(scene.picture().withSampling(new SamplingSettings(antialias, 2)));
        assertTilesEqual(go(sampled).frame().film());
    }

    private static Scene withAntialias(Scene scene, AntialiasMode antialias) {
        return scene.withPicture(scene.picture().withSampling(new SamplingSettings(antialias, 2)));
    }

    @Test
    @Slow
    void antialiasedEdit_showsCentersThenSamples() throws Exception {
        go(withAntialias(scene, AntialiasMode.EDGES));
        loop.render(withAntialias(key(2), AntialiasMode.EDGES));
        RecordingRenderListener.Shown centers = listener.next(RecordingRenderListener.Shown.class);
        assertThat(centers.frame().isFinished()).isFalse();
        assertThat(centers.film().hasSameBits(stale(key(2), scene))).isTrue();
        assertThat(centers.frame().guarantee().scenes().scene()).as("guaranteed scene").isEqualTo(key(2));
        RecordingRenderListener.Shown samples = listener.next(RecordingRenderListener.Shown.class);
        assertThat(samples.frame().isFinished()).isTrue();
        assertThat(samples.film().hasSameBits(stale(withAntialias(key(2), AntialiasMode.EDGES), withAntialias(scene, AntialiasMode.EDGES))))
                .isTrue();
        assertThat(listener.next(WarmSaving.class).isOf(samples.frame().update())).isTrue();
    }

    @Test
    void editDuringSampling_isShownFirstWithoutCancelEvent() throws Exception {
        go(withAntialias(scene, AntialiasMode.EDGES));
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        RecordingRenderListener.Hold centers = listener.holdNextTile();
        loop.render(withAntialias(key(2), AntialiasMode.EDGES));
        centers.awaitReached();
        RecordingRenderListener.Hold samples = listener.holdAfterNextPicture();
        centers.release();
        samples.awaitReached();
        loop.render(withAntialias(key(3), AntialiasMode.EDGES));
        samples.release();
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene())
                .isEqualTo(withAntialias(key(2), AntialiasMode.EDGES));
        Frame newer = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(newer.scene()).isEqualTo(withAntialias(key(3), AntialiasMode.EDGES));
        assertThat(newer.isFinished()).isFalse();
        RecordingRenderListener.Shown last = listener.next(RecordingRenderListener.Shown.class);
        assertThat(last.film().hasSameBits(stale(withAntialias(key(3), AntialiasMode.EDGES), withAntialias(scene, AntialiasMode.EDGES))))
                .isTrue();
        assertThat(listener.events).doesNotContain(RecordingRenderListener.Event.CANCELLED);
    }

    @Test
    void samplesThatDoNotFit_leaveCentersAndAreReported() throws Exception {
        Scene sampled = sized(scene, 400, 300).withPicture(
                scene.picture().withSize(400, 300).withSampling(new SamplingSettings(AntialiasMode.EDGES, 8)));
        long centerBytes;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.renderCenters(renderer.plan(sampled), Progress.NONE);
            centerBytes = renderer.state().bytes();
        }
        try (RenderLoop small = loopWithMemory(centerBytes * 5 / 4)) {
            small.render(sampled);
            assertThat(listener.next(RecordingRenderListener.Shown.class).frame().isFinished()).isFalse();
            assertThat(listener.next(PictureTooLargeException.class)).hasMessageContaining("it would fit with");
        }
    }

    @Test
    void editDuringShownFirstPass_replacesItWithoutCancelEvent() throws Exception {
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(large());
        hold.awaitReached();
        Scene edited = large().withLight(DeskScene.light(scene, "key").withIntensity(2));
        loop.render(edited);
        hold.release();
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().scene()).isEqualTo(edited);
        assertThat(listener.events).doesNotContain(RecordingRenderListener.Event.CANCELLED);
    }

    @Test
    void canceledSamples_leaveCentersUntilNextGo() throws Exception {
        Scene sampled = withAntialias(scene, AntialiasMode.EDGES);
        RecordingRenderListener.Hold samples = listener.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.cancel();
        samples.release();
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        loop.render(sampled);
        assertThat(listener.next(RecordingRenderListener.Shown.class).frame().isFinished()).isFalse();
        assertThat(listener.next(RecordingRenderListener.Shown.class).film().hasSameBits(reference(sampled))).isTrue();
    }

    @Test
    void verificationOfCenters_rendersSamplesFirst() throws Exception {
        Scene sampled = withAntialias(scene, AntialiasMode.EDGES);
        RecordingRenderListener.Hold samples = listener.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.cancel();
        samples.release();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        loop.verify();
        assertThat(awaitFinished().film().hasSameBits(reference(sampled))).isTrue();
        assertThat(listener.next(Verification.class).expectedDifference().isNone()).isTrue();
    }

    @Test
    void newAccuracyDuringSampling_appliesToFinishedPicture() throws Exception {
        Scene sampled = withAntialias(scene, AntialiasMode.EDGES);
        RecordingRenderListener.Hold samples = listener.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.changeOptions(OPTIONS.withAccuracy(Accuracy.RATIO), sampled);
        samples.release();
        RecordingRenderListener.Shown finished = awaitFinished();
        assertThat(FilmError.largestError(finished.film(), reference(sampled))).isLessThanOrEqualTo(finished.frame().update().errorBound());
        listener.expectNext(RecordingRenderListener.Event.IDLE);
    }

    @Test
    void singleLightMode_showsCentersDuringSampling() throws Exception {
        loop.setDisplayMode(DisplayMode.FULL_PICTURE.withLight(Optional.of("key")));
        loop.render(withAntialias(scene, AntialiasMode.EDGES));
        RecordingRenderListener.Shown centers = listener.next(RecordingRenderListener.Shown.class);
        assertThat(centers.frame().isFinished()).isFalse();
        assertThat(centers.frame().displayed().hasSameBits(reference(ContributionScene.of(scene, "key")))).isTrue();
        assertThat(awaitFinished().frame().displayMode().label()).isEqualTo("Only key");
    }

    @Test
    void hiddenEffects_areMissingInCenters() throws Exception {
        loop.setDisplayMode(DisplayMode.FULL_PICTURE.withEffects(ViewEffects.ALL.with(RenderEffect.SHADOWS, false)));
        loop.render(withAntialias(scene, AntialiasMode.EDGES));
        Frame centers = listener.next(RecordingRenderListener.Shown.class).frame();
        assertThat(centers.isFinished()).isFalse();
        assertThat(centers.displayed().hasSameBits(referenceWithEffects(centers.displayMode().effects(), scene))).isTrue();
        Frame last = awaitFinished().frame();
        assertThat(
                last.displayed().hasSameBits(referenceWithEffects(last.displayMode().effects(), withAntialias(scene, AntialiasMode.EDGES))))
                .isTrue();
    }

    @Test
    void editTiles_areNotReported() throws Exception {
        go(scene);
        listener.tiles.clear();
        loop.render(key(0.3));
        listener.next(RecordingRenderListener.Shown.class);
        assertThat(listener.tiles).isEmpty();
    }

    @Test
    void largePicture_showsCoarsePictureFirst() throws Exception {
        loop.render(scene.withPicture(scene.picture().withSize(640, 480).withDepth(0)));
        Film coarse = listener.next(RecordingRenderListener.Coarse.class).film();
        assertThat(coarse.width() * coarse.height()).isBetween(200, 250);
        assertThat(listener.next(RecordingRenderListener.Shown.class).film().width()).isEqualTo(640);
    }

    @Test
    void failingListener_isReportedAndLoopContinues() throws Exception {
        var failing = new RuntimeException("a window's own error");
        var events = new RecordingRenderListener();
        var broken = new RenderListener() {
            @Override
            public void rendered(Frame frame) {
                throw failing;
            }

            @Override
            public void failed(Throwable problem) {
                events.failed(problem);
            }

            @Override
            public void idle() {
                events.idle();
            }
        };
        try (var own = new RenderLoop(OPTIONS, broken)) {
            own.render(scene);
            assertThat(events.next(Throwable.class)).isSameAs(failing);
            events.expectNext(RecordingRenderListener.Event.IDLE);
            own.render(key(2));
            assertThat(events.next(Throwable.class)).isSameAs(failing);
        }
    }

    @Test
    void closeWhileRendering_endsSoon() throws Exception {
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        loop.render(scene.withPicture(scene.picture().withSize(400, 400)));
        hold.awaitReached();
        assertThat(loop.isAlive()).isTrue();
        hold.release();
        loop.close();
        assertThat(loop.isAlive()).isFalse();
    }
}
