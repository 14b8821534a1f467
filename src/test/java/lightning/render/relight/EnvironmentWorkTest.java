package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests that edits of an environment cast rays for its suns alone. */
class EnvironmentWorkTest {
    private static final int SUNS = 2;

    private StudioRenderer studio;

    @BeforeEach
    void open() {
        float[] rgb = new float[3 * 64 * 32];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = 0.1f + i % 11 * 0.05f;
        }
        Arrays.fill(rgb, 3 * (6 * 64 + 40), 3 * (6 * 64 + 41), 200);
        Arrays.fill(rgb, 3 * (10 * 64 + 8), 3 * (10 * 64 + 9), 100);
        Scene scene = StudioScene.of(LightType.POINT);
        studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS,
                scene.withWorld(scene.world().withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(64, 32, rgb))))
                        .withOwn(own -> own.withSoftness(0))));
    }

    @AfterEach
    void close() {
        studio.close();
    }

    private World world() {
        return studio.scene().world();
    }

    private UpdateResult render(World world) {
        UpdateResult update = studio.render(studio.scene().withWorld(world));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "environment-work");
        return update;
    }

    private static void assertNoRay(UpdateResult update) {
        assertThat(update.rays().total()).as(update.plan().description()).isZero();
    }

    @Test
    void environmentIntensity_castsNoRays() {
        for (double intensity : new double[] {2, 0.5, 0, 1}) {
            UpdateResult update = render(world().withOwn(own -> own.withIntensity(intensity)));
            assertNoRay(update);
            assertThat(update.rowsTouched()).isZero();
        }
    }

    /** The image stays: with gain 0, the background has its color, and nothing else is lit by it. */
    @Test
    void environmentGain_castsNoRays() {
        for (double gain : new double[] {2, 0.5, 0, 1}) {
            UpdateResult update = render(world().withOwn(own -> own.withGain(gain)));
            assertNoRay(update);
            assertThat(update.rowsTouched()).isZero();
        }
    }

    @Test
    void solo_darkensOtherLightsWithoutRays() {
        assertNoRay(render(world().withOwn(own -> own.withSolo(true))));
        assertThat(studio.scene().isActive(studio.scene().lights().getFirst())).isFalse();
        assertNoRay(render(world().withOwn(own -> own.withIntensity(0))));
        assertThat(studio.scene().isActive(studio.scene().lights().getFirst())).isTrue();
        assertNoRay(render(world().withOwn(own -> own.withIntensity(1).withGain(0))));
        assertThat(studio.scene().isActive(studio.scene().lights().getFirst())).isTrue();
        assertNoRay(render(world().withOwn(own -> own.withGain(1))));
        assertThat(studio.scene().isActive(studio.scene().lights().getFirst())).isFalse();
        assertNoRay(render(world().withOwn(own -> own.withSolo(false))));
    }

    /** A solo light next to a solo environment shines too; alone it darkens the environment. */
    @Test
    void soloLight_staysOnWithASoloEnvironment() {
        Scene scene = studio.scene();
        Scene both = scene.withWorld(world().withOwn(own -> own.withSolo(true))).withLight(scene.lights().getFirst().withSolo(true));
        assertThat(both.rig().effectiveLights()).allMatch(both::isActive);
        Scene light = both.withWorld(both.world().withOwn(own -> own.withSolo(false)));
        assertThat(light.rig().effectiveLights()).filteredOn(light::isActive).extracting(Light::name)
                .containsExactly(scene.lights().getFirst().name());
    }

    /** The ratio method replaces layers for edge detection; surfels of paths without bounces have none. */
    @Test
    void ratioMethod_findsEdgesInTheLightOfAnEnvironment() {
        Scene scene = studio.scene().withPicture(studio.scene().picture().withSampling(new SamplingSettings(AntialiasMode.EDGES, 2)));
        RenderOptions options = new RenderOptions(Accuracy.RATIO, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1);
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(scene, Progress.NONE);
            renderer.render(scene.withWorld(scene.world().withOwn(own -> own.withRotation(DomeRotation.of(70, 0, 0)))), Progress.NONE);
            assertThat(renderer.cache().indirect()).isNotNull();
        }
    }

    @Test
    void rotatedEnvironment_castsOnlyItsShadowRays() {
        UpdateResult turned = render(world().withOwn(own -> own.withRotation(DomeRotation.of(40, 0, 0))));
        assertThat(StudioRenderer.layers(turned)).first().isEqualTo(new LightUpdate.Keep());
        assertThat(StudioRenderer.layers(turned)).hasSize(1 + SUNS)
                .filteredOn(update -> update.equals(new LightUpdate.FullRecompute(false))).hasSize(SUNS);
        assertThat(turned.plan().steps()).containsExactly("environment 1: full recompute", "environment 2: full recompute", "reflections",
                "gathered light");
        assertThat(turned.rays().eye() + turned.rays().mirrored()).isZero();
        assertThat(turned.rays().shadow()).isEqualTo(facing());
    }

    /** Returns one ray for each row and environment light that it faces. */
    private long facing() {
        var seen = studio.referenceRows();
        return studio.scene().rig().effectiveLights().stream().skip(1)
                .mapToLong(
                        source -> IntStream.rangeClosed(0, studio.scene().picture().depth())
                                .mapToLong(k -> seen.count(k, seen.isFacing(source)))
                                .sum())
                .sum();
    }

    @Test
    void softerEnvironment_castsItsShadowRays() {
        UpdateResult softer = render(world().withOwn(own -> own.withSoftness(1)));
        assertThat(StudioRenderer.layers(softer)).first().isEqualTo(new LightUpdate.Keep());
        assertThat(softer.rays().eye() + softer.rays().mirrored()).isZero();
        assertThat(softer.rays().shadow()).isGreaterThan(facing()).isLessThan(20 * facing());
        assertNoRay(render(world().withOwn(own -> own.withIntensity(3))));
    }

    @Test
    void removedEnvironment_castsNoRaysAndReturnsInFull() {
        World with = world();
        assertNoRay(render(with.withEnvironment(Optional.empty())));
        assertThat(render(with).rays().shadow()).isEqualTo(facing());
    }

    @Test
    void parametersWithoutEnvironment_castNoRays() {
        render(world().withEnvironment(Optional.empty()));
        assertNoRay(render(world().withOwn(own -> own.withRotation(DomeRotation.of(70, 0, 0)).withIntensity(3).withLightCount(9))));
    }
}
