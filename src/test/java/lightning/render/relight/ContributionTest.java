package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.JenScenes;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Contribution;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.light.Emission;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the films of contributions to a picture, read from the cache. */
@Slow
class ContributionTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** Each case traces the reference for each contribution to each scene, so few cases take as long as another property. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void contribution_matchesReferenceOfItsScene(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 2) int threads) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, threads))) {
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                renderer.render(scene, Progress.NONE);
                Film picture = renderer.film().copy();
                ReferenceTracer whole = new ReferenceTracer(scene);
                for (Contribution contribution : renderer.cache().areMirrorsOutdated() ? List.<Contribution>of()
                        : Contribution.all(scene)) {
                    if (!aimsAtGlow(scene, contribution)) {
                        Film expected = new ReferenceTracer(ContributionScene.of(scene, contribution)).trace(whole);
                        SessionAssert.assertSameBits(renderer.contribution(contribution, Progress.NONE), expected, "contribution", session,
                                step, contribution.name(scene));
                    }
                }
                assertThat(renderer.film().hasSameBits(picture)).as("the picture stays").isTrue();
            }
        }
    }

    /** Returns whether rays of blurred reflections are aimed at glowing objects, which do not glow in the picture of another contribution. */
    private static boolean aimsAtGlow(Scene scene, Contribution contribution) {
        return !(contribution instanceof Contribution.OfRest)
                && GatherSettings.of(scene).map(GatherSettings::reflections).orElse(false)
                && scene.materials().stream().anyMatch(m -> !m.glow().isBlack());
    }

    /**
     * Full traces with indirect light are slow, so each step checks one contribution, in turns; the property above checks all of each step.
     */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void contributionWithIndirectLight_matchesFullTraceOfItsScene(@ForAll("sessions") EditSession session,
            @ForAll ReflectionMode reflections, @ForAll @IntRange(min = 1, max = 2) int threads) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, threads));
                WorkerPool workers = new WorkerPool(1)) {
            for (int step : session.steps()) {
                Scene scene = IndirectScenes.withBackground(IndirectScenes.withoutEdges(session.scenes().get(step)));
                renderer.render(scene, Progress.NONE);
                Contribution contribution = Contribution.all(scene).get(step % Contribution.all(scene).size());
                if (renderer.cache().areMirrorsOutdated() || aimsAtGlow(scene, contribution)) {
                    continue;
                }
                Film expected = new TraditionalTracer(ContributionScene.of(scene, contribution), renderer.cache().geometry())
                        .trace(workers, Progress.NONE).film();
                SessionAssert.assertSameBits(renderer.contribution(contribution, Progress.NONE), expected, "indirect contribution", session,
                        step, contribution.name(scene));
            }
        }
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void contributions_addUpToThePicture(@ForAll("sessions") EditSession session, @ForAll Accuracy accuracy, @ForAll boolean indirect) {
        try (Renderer renderer =
                new Renderer(new RenderOptions(accuracy, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1))) {
            for (int step : session.steps()) {
                Scene scene = indirect ? IndirectScenes.withBackground(session.scenes().get(step)) : session.scenes().get(step);
                renderer.render(scene, Progress.NONE);
                List<Film> films = Contribution.all(scene).stream().map(part -> renderer.contribution(part, Progress.NONE)).toList();
                assertSum(films, renderer.film(), "after edit " + step + " of " + session);
            }
        }
    }

    /** Values are never negative: each of the additions along a branch of the sum's tree rounds by half of a last place at most. */
    private static void assertSum(List<Film> films, Film picture, String when) {
        float[] image = picture.toScanlines();
        double[] sum = new double[image.length];
        for (Film film : films) {
            float[] its = film.toScanlines();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += its[i];
            }
        }
        // An environment has two films.
        int roundings = 2 + 32 - Integer.numberOfLeadingZeros(2 * films.size());
        for (int i = 0; i < sum.length; i++) {
            assertThat((double) image[i]).as("value %d %s", i, when)
                    .isCloseTo(sum[i], within(roundings * (0x1p-24 * sum[i] + Float.MIN_VALUE)));
        }
    }

    /** What mirrors show of an earlier scene has the weights of that scene. */
    @Test
    void mirrorsOfAnEarlierScene_belongToNoContribution() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene moved = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withPosition(new Vec3(1, 4, 3)));
        Scene unmirrored = moved.withPicture(moved.picture().withDepth(0));
        RenderOptions stale = RenderOptions.DEFAULT.withThreads(1).withReflections(ReflectionMode.STALE);
        try (Renderer renderer = new Renderer(stale); Renderer plain = new Renderer(stale)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(moved, Progress.NONE);
            plain.render(unmirrored, Progress.NONE);
            assertThat(renderer.film().hasSameBits(plain.film())).isFalse();
            for (Contribution contribution : Contribution.all(moved)) {
                FilmAssert.assertSameBits(renderer.contribution(contribution, Progress.NONE),
                        plain.contribution(contribution, Progress.NONE), "stale");
            }
            renderer.updateReflections(Progress.NONE);
            FilmAssert.assertSameBits(renderer.contribution(new SceneElement.OfLight(StudioScene.KEY), Progress.NONE),
                    new ReferenceTracer(ContributionScene.of(moved, StudioScene.KEY)).trace(), "current");
        }
    }

    /** A bulb glows with its light's color times its intensity; the picture's center shows only the bulb. */
    @Test
    void bulb_isPartOfItsLight() {
        Scene scene = StudioScene.of(LightType.POINT);
        Material bulb = Material.of("matt").withDiffuse(Rgb.BLACK).withSpecular(Rgb.BLACK).withAmbient(Rgb.BLACK)
                .withBulb(Bulb.NONE.withLight(StudioScene.KEY));
        Light key = scene.light(StudioScene.KEY).orElseThrow().withColor(new Rgb(1, 0.5, 0.25)).withIntensity(3);
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene.withMaterial(bulb).withLight(key), Progress.NONE);
            Film shown = renderer.contribution(Contribution.of(key), Progress.NONE);
            assertThat(List.of(shown.red(15, 12), shown.green(15, 12), shown.blue(15, 12))).containsExactly(3f, 1.5f, 0.75f);
            Film rest = renderer.contribution(new Contribution.OfRest(), Progress.NONE);
            assertThat(rest.hasSameBits(Film.black(rest.width(), rest.height()))).isTrue();
        }
    }

    @Test
    void missingLight_isBlack() {
        assertIsBlack("no", StudioScene.of(LightType.SPOT));
    }

    private static void assertIsBlack(String light, Scene scene) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            Film film = renderer.contribution(new SceneElement.OfLight(light), Progress.NONE);
            assertThat(film.hasSameBits(Film.black(film.width(), film.height()))).isTrue();
        }
    }

    @Test
    void onlyLightOfScene_isThePictureForEachUnitOfLength() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene alone = scene.withLights(List.of(key.withEmission(Emission.DEFAULT.withUnit(IntensityUnit.CANDELA))))
                .withWorld(new World(0, Rgb.BLACK).withMeters(0.01));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(alone, Progress.NONE);
            Film film = renderer.contribution(new SceneElement.OfLight(StudioScene.KEY), Progress.NONE);
            assertThat(film.hasSameBits(renderer.film())).isTrue();
            assertThat(film.hasSameBits(Film.black(film.width(), film.height()))).isFalse();
        }
    }

    @Test
    void indirectLightBelowEnvironment_takesItsPaths() {
        Scene scene = IndirectScenes.all().get("environment with a sun");
        Scene one = ContributionScene.of(scene, "panel");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));
                WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            Film film = renderer.contribution(new SceneElement.OfLight("panel"), Progress.NONE);
            Film traced = new TraditionalTracer(one).trace(workers, Progress.NONE).film();
            assertThat(film.hasSameBits(traced)).isTrue();
        }
    }

    @Test
    void environment_matchesReferenceOfItsScene() {
        Scene scene = JenScenes.withSky(StudioScene.of(LightType.SPOT));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            FilmAssert.assertSameBits(renderer.contribution(Contribution.ENVIRONMENT, Progress.NONE),
                    new ReferenceTracer(ContributionScene.of(scene, Contribution.ENVIRONMENT)).trace(new ReferenceTracer(scene)),
                    "environment");
        }
    }

    @Test
    void switchedOffLight_isBlack() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene dark = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withOn(false));
        assertIsBlack(StudioScene.KEY, dark);
    }

    @Test
    void lightMutedBySolo_isBlack() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene solo = scene.withLights(List.of(key, key.withName("other").withSolo(true)));
        assertIsBlack(StudioScene.KEY, solo);
    }

    @Test
    void mirrorsStoredAsHitShapes_haveNoContributions() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene mirroring = scene.withPicture(scene.picture().withDepth(2));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withStorage(MirrorStorage.HIT_SHAPES))) {
            renderer.render(mirroring, Progress.NONE);
            assertThatThrownBy(() -> renderer.contribution(new SceneElement.OfLight(StudioScene.KEY), Progress.NONE))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("mirror levels are stored as hit shapes");
        }
    }
}
