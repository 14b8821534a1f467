package lightning.editor.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Progress;
import lightning.base.work.Wait;
import lightning.base.work.Workers;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.editor.document.Desk;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.LightShare;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Geometry;
import lightning.sample.Slow;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RenderLoopTest {
    private static final Options OPTIONS = Options.DEFAULT.withReflections(Reflections.STALE).withThreads(1);

    private final LoopEar ear = new LoopEar();
    private final RenderLoop loop = new RenderLoop(OPTIONS, ear);
    private final Scene scene = Desk.scene();

    @AfterEach
    void close() {
        loop.close();
    }

    private Scene key(double intensity) {
        return Desk.done(Desk.dial("intensity").set(scene, "key", intensity));
    }

    private static Film reference(Scene scene) {
        return new ReferenceTracer(scene).trace();
    }

    private static Film stale(Scene scene, Scene mirrored) {
        try (var workers = new Workers(1)) {
            return new TraditionalTracer(scene, mirrored, new Geometry(scene)).trace(workers, Progress.NONE).film();
        }
    }

    private LoopEar.Shown go(Scene wanted) throws InterruptedException {
        loop.render(wanted);
        return finished();
    }

    /** The next picture with all its samples. */
    private LoopEar.Shown finished() throws InterruptedException {
        LoopEar.Shown shown = ear.next(LoopEar.Shown.class);
        while (!shown.frame().finished()) {
            shown = ear.next(LoopEar.Shown.class);
        }
        return shown;
    }

    /** One that is worth a coarse look, and no second one. */
    private Scene large() {
        return scene.withPicture(scene.picture().withSize(240, 160));
    }

    /** The width of the one coarse picture that is told of. */
    private int lookAt(Scene wanted, Future<Optional<CoarsePicture>> begun) throws Exception {
        loop.begin(begun);
        loop.render(wanted);
        Film seen = ear.next(LoopEar.Coarse.class).film();
        finished();
        assertThat(ear.events).noneMatch(LoopEar.Coarse.class::isInstance);
        return seen.width();
    }

    private static Future<Optional<CoarsePicture>> look(Scene of) {
        return CompletableFuture.completedFuture(Optional.of(new CoarsePicture(of, new Geometry(of), Film.black(3, 2))));
    }

    @Test
    void sceneThatIsLookedAtElsewhere_isNotLookedAtAgain() throws Exception {
        Scene wanted = large();
        assertThat(lookAt(wanted, look(wanted))).isEqualTo(3);
    }

    @Test
    void lookAtAnotherScene_isNone() throws Exception {
        assertThat(lookAt(large(), look(large()))).isGreaterThan(3);
    }

    @Test
    void lookThatFails_isMadeByTheLoop() throws Exception {
        assertThat(lookAt(large(), CompletableFuture.failedFuture(new OutOfMemoryError()))).isGreaterThan(3);
    }

    @Test
    void pictureThatIsTooLarge_isNotLookedAt() {
        Scene huge = scene.withPicture(scene.picture().withSize(16_384, 16_384));
        assertThat(CoarsePicture.first(huge, OPTIONS.withMemory(1 << 20))).isEmpty();
    }

    @Test
    void firstPicture_equalsTheReference() throws Exception {
        LoopEar.Shown shown = go(scene);
        assertThat(shown.film().sameBits(reference(scene))).isTrue();
        assertThat(shown.frame().scene()).isEqualTo(scene);
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.FirstPass.class);
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void planThatIsTold_isTheOneThatIsCarriedOut() throws Exception {
        go(scene);
        ear.events.clear();
        loop.render(key(0.3));
        UpdatePlan told = ear.next(LoopEar.Started.class).plan();
        assertThat(ear.next(LoopEar.Shown.class).frame().update().plan()).isSameAs(told);
    }

    private static Scene sized(Scene scene, int width, int height) {
        return scene.withPicture(scene.picture().withSize(width, height));
    }

    /** The loop with so much memory. */
    private RenderLoop with(long memory) {
        return new RenderLoop(OPTIONS.withMemory(memory), ear);
    }

    @Test
    void pictureThatDoesNotFit_isRefusedBeforeAnyPartOfItIsTraced() throws Exception {
        try (RenderLoop small = with(50_000_000)) {
            small.render(sized(scene, 2048, 2048));
            assertThat(ear.events.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isInstanceOf(LoopEar.Started.class);
            assertThat(ear.events.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isInstanceOf(PictureTooLarge.class);
        }
    }

    @Test
    void pictureThatFitsOnlyAlone_takesThePlaceOfTheOneBefore() throws Exception {
        Scene first = sized(scene, 256, 192);
        Scene second = sized(scene, 256, 191);
        long each;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(first, Progress.NONE);
            each = MemoryNeed.of(renderer.cache());
        }
        try (RenderLoop small = with(each * 3 / 2)) {
            small.render(first);
            ear.next(LoopEar.Shown.class);
            small.render(second);
            assertThat(ear.next(LoopEar.Shown.class).frame().scene()).isEqualTo(second);
        }
    }

    @Test
    void pictureWithoutEffectsThatDoesNotFitBesideThePicture_isToldAndThePictureIsShown() throws Exception {
        Scene first = sized(scene, 256, 192);
        long each;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(first, Progress.NONE);
            each = MemoryNeed.of(renderer.cache());
        }
        try (RenderLoop small = with(each * 5 / 4)) {
            small.setLook(Look.PLAIN.withEffects(ViewEffects.ALL.with(Effect.SPECULAR, false)));
            small.render(first);
            LoopEar.Shown shown = ear.next(LoopEar.Shown.class);
            assertThat(shown.frame().look()).isEqualTo(Look.PLAIN);
            assertThat(shown.frame().seen().sameBits(reference(first))).isTrue();
            ear.next(PictureTooLarge.class);
        }
    }

    @Test
    void edit_isAnUpdateWithStaleMirrors() throws Exception {
        go(scene);
        LoopEar.Shown shown = go(key(2));
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(shown.film().sameBits(stale(key(2), scene))).isTrue();
        assertThat(shown.frame().mirrorsAreCurrent()).isFalse();
    }

    @Test
    void updateReflections_givesTheReference() throws Exception {
        go(scene);
        go(key(2));
        loop.updateReflections();
        LoopEar.Shown shown = ear.next(LoopEar.Shown.class);
        assertThat(shown.film().sameBits(reference(key(2)))).isTrue();
        assertThat(shown.frame().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void work_isFollowedByIdle() throws Exception {
        go(scene);
        ear.nextIs(LoopEar.Event.IDLE);
        assertThat(loop.isBusy()).isFalse();
    }

    @Test
    void editsWhileRendering_onlyTheNewestIsRendered() throws Exception {
        go(scene);
        LoopEar.Hold hold = ear.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        assertThat(loop.isBusy()).isTrue();
        loop.render(key(3));
        loop.render(key(4));
        hold.release();
        assertThat(ear.next(LoopEar.Shown.class).frame().scene()).isEqualTo(key(2));
        assertThat(ear.next(LoopEar.Shown.class).frame().scene()).isEqualTo(key(4));
    }

    @Test
    void anotherSizeWhileTracing_cancelsTheTrace() throws Exception {
        LoopEar.Hold hold = ear.holdNextTile();
        loop.render(scene.withPicture(scene.picture().withSize(200, 200)));
        hold.awaitReached();
        loop.render(scene);
        hold.release();
        ear.nextIs(LoopEar.Event.CANCELLED);
        assertThat(ear.next(LoopEar.Shown.class).frame().scene()).isEqualTo(scene);
    }

    @Test
    void editWhileMirrorsUpdate_isRenderedFirstAndThenTheMirrors() throws Exception {
        go(scene);
        go(key(2));
        LoopEar.Hold hold = ear.holdNextTile();
        loop.updateReflections();
        hold.awaitReached();
        loop.render(key(3));
        hold.release();
        ear.nextIs(LoopEar.Event.CANCELLED);
        assertThat(ear.next(LoopEar.Shown.class).frame().mirrored()).isEqualTo(scene);
        assertThat(ear.next(LoopEar.Shown.class).film().sameBits(reference(key(3)))).isTrue();
    }

    @Test
    void cancel_keepsTheLastPictureAndForgetsWhatWaits() throws Exception {
        go(scene);
        ear.nextIs(LoopEar.Event.IDLE);
        LoopEar.Hold hold = ear.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        loop.render(key(3));
        loop.updateReflections();
        loop.cancel();
        hold.release();
        ear.nextIs(LoopEar.Event.CANCELLED);
        ear.nextIs(LoopEar.Event.IDLE);
        assertThat(loop.isBusy()).isFalse();
        LoopEar.Shown shown = go(key(4));
        assertThat(shown.film().sameBits(stale(key(4), scene))).isTrue();
    }

    @Test
    void undoneEdit_isRenderedForNothing() throws Exception {
        go(scene);
        assertThat(go(scene).frame().update().plan()).isInstanceOf(UpdatePlan.Nothing.class);
    }

    @Test
    void verification_ofCurrentMirrorsFindsNoDifference() throws Exception {
        go(scene);
        loop.verify();
        Verification verification = ear.next(Verification.class);
        assertThat(verification.current().isNone()).isTrue();
        assertThat(verification.full().sameBits(reference(scene))).isTrue();
    }

    @Test
    void verification_ofStaleMirrorsShowsThemAndThatThePromiseIsKept() throws Exception {
        go(scene);
        go(key(5));
        loop.verify();
        Verification verification = ear.next(Verification.class);
        assertThat(verification.current().isNone()).isFalse();
        assertThat(verification.promised().isNone()).isTrue();
        assertThat(verification.promise().scenes().scene()).isEqualTo(key(5));
    }

    private Scene sized(int width, int height) {
        return scene.withPicture(scene.picture().withSize(width, height));
    }

    @Test
    @Slow
    void edit_isFollowedByWhatItSaves() throws Exception {
        go(scene);
        for (int i = 1; i < 3; i++) {
            Frame frame = go(key(i + 1)).frame();
            assertThat(ear.next(WarmSaving.class).isOf(frame.update())).isTrue();
        }
        loop.updateReflections();
        Frame mirrored = ear.next(LoopEar.Shown.class).frame();
        assertThat(ear.next(WarmSaving.class).isOf(mirrored.update())).isTrue();
    }

    @Test
    @Slow
    void firstPictureAndAnotherAccuracy_saveNothing() throws Exception {
        go(scene);
        go(sized(50, 40));
        loop.reopen(OPTIONS.withAccuracy(Accuracy.RATIO));
        Update converted = ear.next(LoopEar.Shown.class).frame().update();
        Scene brighter = sized(50, 40).withLight(Desk.light(scene, "key").withIntensity(2));
        Update edited = go(brighter).frame().update();
        WarmSaving first = ear.next(WarmSaving.class);
        assertThat(first.isOf(converted)).isFalse();
        assertThat(first.isOf(edited)).isTrue();
    }

    @Test
    @Slow
    void workWhileMeasuring_isNotHeldUpAndTheNewerEditIsMeasured() throws Exception {
        go(sized(400, 300));
        Scene brighter = sized(400, 300).withLight(Desk.light(scene, "key").withIntensity(2));
        go(brighter);
        ear.nextIs(LoopEar.Event.IDLE);
        Update newer = go(brighter.withLight(Desk.light(scene, "key").withIntensity(3))).frame().update();
        assertThat(ear.next(WarmSaving.class).isOf(newer)).isTrue();
    }

    @Test
    @Slow
    void verificationWhileMeasuring_letsItBeginAgain() throws Exception {
        go(scene);
        Update update = go(key(2)).frame().update();
        ear.nextIs(LoopEar.Event.IDLE);
        loop.verify();
        ear.next(Verification.class);
        assertThat(ear.next(WarmSaving.class).isOf(update)).isTrue();
    }

    @Test
    void lookAtOneLight_showsItsShareAndLeavesThePicture() throws Exception {
        go(scene);
        go(key(2));
        loop.setLook(Look.PLAIN.withLight(Optional.of("key")));
        Frame frame = ear.next(LoopEar.Shown.class).frame();
        Film share = new ReferenceTracer(LightShare.scene(key(2), "key"), LightShare.scene(scene, "key")).trace();
        assertThat(frame.seen().sameBits(share)).isTrue();
        assertThat(frame.film().sameBits(stale(key(2), scene))).isTrue();
        assertThat(frame.look().label()).isEqualTo("Only key");
        loop.verify();
        assertThat(ear.next(Verification.class).promised().isNone()).isTrue();
        assertThat(go(key(3)).frame().seen().sameBits(new ReferenceTracer(LightShare.scene(key(3), "key"),
                LightShare.scene(scene, "key")).trace())).isTrue();
        loop.setLook(Look.PLAIN);
        frame = ear.next(LoopEar.Shown.class).frame();
        assertThat(frame.seen().sameBits(frame.film())).isTrue();
    }

    @Test
    void hiddenEffects_areGoneFromTheLookAlone() throws Exception {
        go(scene);
        go(key(2));
        ViewEffects dull = ViewEffects.ALL.hiding(Set.of(Effect.SHADOWS, Effect.REFLECTION));
        loop.setLook(Look.PLAIN.withEffects(dull));
        Frame frame = ear.next(LoopEar.Shown.class).frame();
        assertThat(frame.seen().sameBits(without(dull, key(2)))).isTrue();
        assertThat(frame.film().sameBits(stale(key(2), scene))).isTrue();
        assertThat(frame.look().label()).isEqualTo("No shadows, no reflections");
        assertThat(go(key(3)).frame().seen().sameBits(without(dull, key(3)))).isTrue();
    }

    private static Film without(ViewEffects effects, Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS.withView(effects))) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    @Test
    void hiddenShadows_leaveTheMirrorsAsOldAsThePictures() throws Exception {
        go(scene);
        go(key(2));
        loop.setLook(Look.PLAIN.withEffects(ViewEffects.ALL.withLitTextures(false)));
        Frame frame = ear.next(LoopEar.Shown.class).frame();
        assertThat(frame.seen().sameBits(stale(key(2), scene))).as("there are no textures").isTrue();
    }

    @Test
    void withoutAPicture_mirrorsAndVerificationDoNothing() throws Exception {
        loop.updateReflections();
        loop.verify();
        ear.nextIs(LoopEar.Event.IDLE);
        go(scene);
        assertThat(ear.events).noneMatch(e -> e instanceof Verification || e instanceof Throwable);
    }

    @Test
    void anotherAccuracy_keepsWhatIsKnownOfTheScene() throws Exception {
        go(scene);
        go(key(2));
        loop.reopen(OPTIONS.withAccuracy(Accuracy.RATIO));
        LoopEar.Shown shown = ear.next(LoopEar.Shown.class);
        assertThat(shown.frame().scene()).isEqualTo(key(2));
        assertThat(shown.frame().update().rays()).isEqualTo(TraceCounts.NONE);
        loop.reopen(OPTIONS.withReflections(Reflections.CURRENT));
        shown = ear.next(LoopEar.Shown.class);
        assertThat(shown.frame().update().rays()).isEqualTo(TraceCounts.NONE);
        assertThat(shown.film().sameBits(reference(key(2)))).isTrue();
        assertThat(go(key(3)).film().sameBits(reference(key(3)))).isTrue();
    }

    @Test
    void accuracyAndSceneTogether_areOneUpdate() throws Exception {
        go(scene);
        LoopEar.Hold hold = ear.holdNextTile();
        loop.render(key(2));
        hold.awaitReached();
        loop.reopen(OPTIONS.withAccuracy(Accuracy.RATIO));
        loop.render(key(3));
        hold.release();
        ear.next(LoopEar.Shown.class);
        LoopEar.Shown shown = ear.next(LoopEar.Shown.class);
        assertThat(shown.frame().scene()).isEqualTo(key(3));
        assertThat(shown.frame().update().plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(shown.frame().update().rays()).isEqualTo(TraceCounts.NONE);
    }

    private void assertThatTilesAreThoseOf(Film film) {
        assertThat(ear.tiles).hasSize(film.tileCount());
        assertThat(ear.tiles).allSatisfy(
                (tile, rgb) -> assertThat(rgb).isDeepEqualTo(new float[][] {film.red(tile), film.green(tile), film.blue(tile)}));
    }

    @ParameterizedTest
    @EnumSource(Antialias.class)
    void tilesOfAFirstPass_areToldBeforeThePicture(Antialias antialias) throws Exception {
        Scene sampled = scene.withPicture(scene.picture().withSampling(new Sampling(antialias, 2)));
        assertThatTilesAreThoseOf(go(sampled).frame().film());
    }

    private static Scene at(Scene scene, Antialias antialias) {
        return scene.withPicture(scene.picture().withSampling(new Sampling(antialias, 2)));
    }

    @Test
    @Slow
    void editOfAnAntialiasedPicture_showsTheCentresAndThenTheSamples() throws Exception {
        go(at(scene, Antialias.EDGES));
        loop.render(at(key(2), Antialias.EDGES));
        LoopEar.Shown centers = ear.next(LoopEar.Shown.class);
        assertThat(centers.frame().finished()).isFalse();
        assertThat(centers.film().sameBits(stale(key(2), scene))).isTrue();
        assertThat(centers.frame().promise().scenes().scene()).as("what it is equal to").isEqualTo(key(2));
        LoopEar.Shown samples = ear.next(LoopEar.Shown.class);
        assertThat(samples.frame().finished()).isTrue();
        assertThat(samples.film().sameBits(stale(at(key(2), Antialias.EDGES), at(scene, Antialias.EDGES)))).isTrue();
        assertThat(ear.next(WarmSaving.class).isOf(samples.frame().update())).isTrue();
    }

    @Test
    void editWhileSamplesAreMade_isShownBeforeThemAndNobodyHearsOfACancelledWork() throws Exception {
        go(at(scene, Antialias.EDGES));
        ear.nextIs(LoopEar.Event.IDLE);
        LoopEar.Hold centers = ear.holdNextTile();
        loop.render(at(key(2), Antialias.EDGES));
        centers.awaitReached();
        LoopEar.Hold samples = ear.holdAfterNextPicture();
        centers.release();
        samples.awaitReached();
        loop.render(at(key(3), Antialias.EDGES));
        samples.release();
        assertThat(ear.next(LoopEar.Shown.class).frame().scene()).isEqualTo(at(key(2), Antialias.EDGES));
        Frame newer = ear.next(LoopEar.Shown.class).frame();
        assertThat(newer.scene()).isEqualTo(at(key(3), Antialias.EDGES));
        assertThat(newer.finished()).isFalse();
        LoopEar.Shown last = ear.next(LoopEar.Shown.class);
        assertThat(last.film().sameBits(stale(at(key(3), Antialias.EDGES), at(scene, Antialias.EDGES)))).isTrue();
        assertThat(ear.events).doesNotContain(LoopEar.Event.CANCELLED);
    }

    @Test
    void samplesThatAreCancelled_leaveTheCentresUntilTheNextGo() throws Exception {
        Scene sampled = at(scene, Antialias.EDGES);
        LoopEar.Hold samples = ear.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.cancel();
        samples.release();
        ear.nextIs(LoopEar.Event.CANCELLED);
        ear.nextIs(LoopEar.Event.IDLE);
        loop.render(sampled);
        assertThat(ear.next(LoopEar.Shown.class).frame().finished()).isFalse();
        assertThat(ear.next(LoopEar.Shown.class).film().sameBits(reference(sampled))).isTrue();
    }

    @Test
    void verificationOfCentres_makesTheSamplesFirst() throws Exception {
        Scene sampled = at(scene, Antialias.EDGES);
        LoopEar.Hold samples = ear.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.cancel();
        samples.release();
        ear.nextIs(LoopEar.Event.IDLE);
        loop.verify();
        assertThat(finished().film().sameBits(reference(sampled))).isTrue();
        assertThat(ear.next(Verification.class).promised().isNone()).isTrue();
    }

    @Test
    void anotherAccuracyWhileSamplesAreMade_isOfTheFinishedPicture() throws Exception {
        Scene sampled = at(scene, Antialias.EDGES);
        LoopEar.Hold samples = ear.holdAfterNextPicture();
        loop.render(sampled);
        samples.awaitReached();
        loop.reopen(OPTIONS.withAccuracy(Accuracy.RATIO), sampled);
        samples.release();
        assertThat(finished().film().sameBits(reference(sampled))).isTrue();
        ear.nextIs(LoopEar.Event.IDLE);
    }

    @Test
    void lookAtOneLight_isOfTheCentresWhileSamplesAreMade() throws Exception {
        loop.setLook(Look.PLAIN.withLight(Optional.of("key")));
        loop.render(at(scene, Antialias.EDGES));
        LoopEar.Shown centers = ear.next(LoopEar.Shown.class);
        assertThat(centers.frame().finished()).isFalse();
        assertThat(centers.frame().seen().sameBits(reference(LightShare.scene(scene, "key")))).isTrue();
        assertThat(finished().frame().look().label()).isEqualTo("Only key");
    }

    @Test
    void hiddenEffects_areGoneFromTheCentresToo() throws Exception {
        loop.setLook(Look.PLAIN.withEffects(ViewEffects.ALL.with(Effect.SHADOWS, false)));
        loop.render(at(scene, Antialias.EDGES));
        Frame centers = ear.next(LoopEar.Shown.class).frame();
        assertThat(centers.finished()).isFalse();
        assertThat(centers.seen().sameBits(without(centers.look().effects(), scene))).isTrue();
        Frame last = finished().frame();
        assertThat(last.seen().sameBits(without(last.look().effects(), at(scene, Antialias.EDGES)))).isTrue();
    }

    @Test
    void tilesOfAnEdit_areNotTold() throws Exception {
        go(scene);
        ear.tiles.clear();
        loop.render(key(0.3));
        ear.next(LoopEar.Shown.class);
        assertThat(ear.tiles).isEmpty();
    }

    @Test
    void largePicture_hasACoarseOneFirst() throws Exception {
        loop.render(scene.withPicture(scene.picture().withSize(640, 480).withDepth(0)));
        Film coarse = ear.next(LoopEar.Coarse.class).film();
        assertThat(coarse.width() * coarse.height()).isBetween(1900, 2000);
        assertThat(ear.next(LoopEar.Shown.class).film().width()).isEqualTo(640);
    }

    @Test
    void listenerThatFails_isToldAndTheLoopLivesOn() throws Exception {
        var failing = new RuntimeException("a window's own error");
        var events = new LoopEar();
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
            events.nextIs(LoopEar.Event.IDLE);
            own.render(key(2));
            assertThat(events.next(Throwable.class)).isSameAs(failing);
        }
    }

    @Test
    void closedWhileRendering_endsSoon() throws Exception {
        LoopEar.Hold hold = ear.holdNextTile();
        loop.render(scene.withPicture(scene.picture().withSize(400, 400)));
        hold.awaitReached();
        assertThat(loop.isAlive()).isTrue();
        hold.release();
        loop.close();
        assertThat(loop.isAlive()).isFalse();
    }
}
