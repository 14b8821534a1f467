package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.EditSession;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Emission;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the image of one light's contribution, composed from the cache. */
@Slow
class LightImageTest {

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    /** Each case traces the reference for each light of each scene, so few cases take as long as another property. */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void lightImage_matchesReferenceOfSingleLight(@ForAll("sessions") EditSession session, @ForAll ReflectionMode reflections,
            @ForAll @IntRange(min = 1, max = 2) int threads) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, threads))) {
            for (int step : session.steps()) {
                Scene scene = session.scenes().get(step);
                renderer.render(scene, Progress.NONE);
                Film picture = renderer.film().copy();
                for (Light light : aimsAtGlow(scene) || aimsAtGlow(renderer.cache().mirrored().scene()) ? List.<Light>of()
                        : scene.lights()) {
                    Film expected = new ReferenceTracer(LightImage.scene(scene, light.name()),
                            LightImage.scene(renderer.cache().mirrored().scene(), light.name()))
                            .trace(ReferenceCheck.referenceTracer(renderer.cache().scenes()));
                    SessionAssert.assertSameBits(renderer.lightImage(light.name(), Progress.NONE), expected, "share", session, step,
                            light.name());
                }
                assertThat(renderer.film().hasSameBits(picture)).as("the picture stays").isTrue();
            }
        }
    }

    /** Returns whether rays of blurred reflections are aimed at glowing objects, which do not glow in the picture of a light alone. */
    private static boolean aimsAtGlow(Scene scene) {
        return GatherSettings.of(scene).map(GatherSettings::reflections).orElse(false)
                && scene.materials().stream().anyMatch(m -> !m.glow().isBlack() || !m.bulb().light().isEmpty());
    }

    /**
     * The background lights the picture, but is no part of a light's contribution. Full traces with indirect light are slow, so each step
     * checks one light, in turns; the property above checks all lights of each step.
     */
    @Property(edgeCases = EdgeCasesMode.NONE)
    void lightImageWithIndirectLight_matchesFullTraceOfSingleLight(@ForAll("sessions") EditSession session,
            @ForAll ReflectionMode reflections, @ForAll @IntRange(min = 1, max = 2) int threads) {
        try (Renderer renderer = new Renderer(new RenderOptions(Accuracy.EXACT, reflections, MirrorStorage.FULL_ROWS, threads));
                WorkerPool workers = new WorkerPool(1)) {
            for (int step : session.steps()) {
                Scene scene = IndirectScenes.withBackground(IndirectScenes.withoutEdges(session.scenes().get(step)));
                renderer.render(scene, Progress.NONE);
                if (scene.lights().isEmpty() || aimsAtGlow(renderer.scene()) || aimsAtGlow(renderer.cache().mirrored().scene())) {
                    continue;
                }
                Light light = scene.lights().get(step % scene.lights().size());
                Scene one = LightImage.scene(renderer.scene(), light.name());
                Scene mirrored = LightImage.scene(renderer.cache().mirrored().scene(), light.name());
                Film expected = new TraditionalTracer(one, mirrored, renderer.cache().geometry()).trace(workers, Progress.NONE).film();
                SessionAssert.assertSameBits(renderer.lightImage(light.name(), Progress.NONE), expected, "indirect share", session,
                        step,
                        light.name());
            }
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
            Film share = renderer.lightImage(StudioScene.KEY, Progress.NONE);
            assertThat(share.hasSameBits(renderer.film())).isTrue();
            assertThat(share.hasSameBits(Film.black(share.width(), share.height()))).isFalse();
        }
    }

    @Test
    void indirectLightBelowEnvironment_takesItsPaths() {
        Scene scene = IndirectScenes.all().get("environment with a sun");
        Scene one = LightImage.scene(scene, "panel");
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1));
                WorkerPool workers = new WorkerPool(1)) {
            renderer.render(scene, Progress.NONE);
            Film share = renderer.lightImage("panel", Progress.NONE);
            Film traced = new TraditionalTracer(one).trace(workers, Progress.NONE).film();
            assertThat(share.hasSameBits(traced)).isTrue();
        }
    }

    @Test
    void switchedOffLight_isBlack() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene dark = scene.withLight(scene.light(StudioScene.KEY).orElseThrow().withOn(false));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(dark, Progress.NONE);
            Film share = renderer.lightImage(StudioScene.KEY, Progress.NONE);
            assertThat(share.hasSameBits(Film.black(share.width(), share.height()))).isTrue();
        }
    }

    @Test
    void lightMutedBySolo_isBlack() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        Scene solo = scene.withLights(List.of(key, key.withName("other").withSolo(true)));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            renderer.render(solo, Progress.NONE);
            Film share = renderer.lightImage(StudioScene.KEY, Progress.NONE);
            assertThat(share.hasSameBits(Film.black(share.width(), share.height()))).isTrue();
        }
    }

    @Test
    void mirrorsStoredAsHitShapes_haveNoLightImage() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Scene mirroring = scene.withPicture(scene.picture().withDepth(2));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withStorage(MirrorStorage.HIT_SHAPES))) {
            renderer.render(mirroring, Progress.NONE);
            assertThatThrownBy(() -> renderer.lightImage(StudioScene.KEY, Progress.NONE)).isInstanceOf(IllegalStateException.class)
                    .hasMessage("mirror levels are stored as hit shapes");
        }
    }
}
