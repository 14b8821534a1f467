package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.Session;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Panorama;
import lightning.scene.Scene;
import lightning.scene.Sky;
import lightning.scene.World;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Which lights matter, held against the reference. */
@Slow
class ContributionsTest {
    private static final Options OPTIONS = new Options(Accuracy.EXACT, Reflections.CURRENT, MirrorStorage.FULL_ROWS, 1);

    @Provide
    Arbitrary<Session> sessions() {
        return Session.sessions();
    }

    @Property(tries = 25, edgeCases = EdgeCasesMode.NONE)
    void pictureWithoutALight_isTheReferences(@ForAll("sessions") Session session) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            Scene scene = session.scenes().getLast();
            renderer.render(scene, Progress.NONE);
            Film picture = renderer.film().copy();
            Contributions found = Contributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT,
                    Contributions.Region.all(picture), Progress.NONE);
            assertThat(found.lights()).extracting(Contribution::light).isEqualTo(scene.lights().stream().map(Light::name).toList());
            for (Contribution one : found.lights()) {
                if (one.shines()) {
                    Film without = new ReferenceTracer(Contributions.off(scene, List.of(one.light()))).trace();
                    assertThat(one.without()).isEqualTo(Contribution.Change.between(picture, without, ViewTransform.DEFAULT));
                    assertThat(one.region()).isEqualTo(one.picture());
                }
            }
            Film dark = new ReferenceTracer(Contributions.off(scene, found.idle())).trace();
            assertThat(Contribution.Change.between(picture, dark, ViewTransform.DEFAULT)).isEqualTo(found.without());
            assertThat(found.without().isUnseen()).isTrue();
            assertThat(renderer.film().sameBits(picture)).as("the picture stays").isTrue();
        }
    }

    private static Contributions of(Scene scene, Contributions.Region region) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return Contributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT, region, Progress.NONE);
        }
    }

    @Test
    void shares_ofLightsThatAreAllThereIs_addUpToAll() {
        Scene scene = StudioScene.of(LightType.POINT);
        Scene lit = scene.withWorld(scene.world().withAmbience(0).withBackground(lightning.base.math.Rgb.BLACK));
        Contributions found = of(lit, new Contributions.Region(0, 0, 5, 5));
        assertThat(found.lights().stream().mapToDouble(Contribution::picture).sum()).isCloseTo(1, within(1e-6));
        assertThat(found.lights()).extracting(Contribution::region)
                .isNotEqualTo(found.lights().stream().map(Contribution::picture).toList());
    }

    @Test
    void lightsThatNobodySees_areIdleAndTheOthersAreNot() {
        Scene scene = StudioScene.of(LightType.POINT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        List<Light> lights = new java.util.ArrayList<>(scene.lights());
        lights.add(key.withName("dim").withIntensity(1e-7));
        lights.add(key.withName("far below").withPosition(new Vec3(0, -1e6, 0)));
        lights.add(key.withName("off").withOn(false));
        Contributions found = of(scene.withLights(lights), new Contributions.Region(0, 0, 1, 1));
        assertThat(found.idle()).contains("dim").doesNotContain(StudioScene.KEY, "off");
        assertThat(found.lights().stream().filter(c -> c.light().equals("off")).findFirst().orElseThrow().shines()).isFalse();
    }

    /** A white wall that both lights meet head-on, so that all pixels are as bright as both: 0.5/255/12.92 is the least that is displayed as 1. */
    @Test
    void lightsThatAreSeenTogetherOnly_areNotBothIdle() throws Exception {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 8 8  depth 0 }
                camera { from 0 0 5  to 0 0 0 }
                world { ambience 0  background 0 0 0 }
                material white { diffuse 1 1 1  specular 0 0 0  ambient 0 0 0 }
                plane wall { material white  rotate 90 0 0  scale 100 1 100 }
                light a directional { direction 0 0 -1  intensity 0.00017 }
                light b directional { direction 0 0 -1  intensity 0.00016 }
                """, "wall", Path.of("")).scene();
        Contributions found = of(scene, new Contributions.Region(0, 0, 1, 1));
        assertThat(found.lights()).allMatch(one -> one.without().isUnseen() && !one.without().isNone());
        assertThat(found.idle()).containsExactly("b");
    }

    @Test
    void environment_hasWhatIsLostWithoutIt() {
        Scene scene = StudioScene.of(LightType.POINT);
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 0.5f);
        World around = scene.world().withAmbience(0).withEnvironment(Optional.of(new Panorama("sky.hdr", new Sky(8, 4, rgb)))).withLamps(6);
        Scene lit = scene.withWorld(around);
        Contribution environment = of(lit, new Contributions.Region(0, 0, 5, 5)).environment().orElseThrow();
        Film picture = new ReferenceTracer(lit).trace();
        Film without = new ReferenceTracer(scene.withWorld(around.withIntensity(0))).trace();
        assertThat(environment.light()).isEqualTo("environment");
        assertThat(environment.shines()).isTrue();
        assertThat(environment.without()).isEqualTo(Contribution.Change.between(picture, without, ViewTransform.DEFAULT));
        Film alone = new ReferenceTracer(Contributions.off(lit, scene.lights().stream().map(Light::name).toList())).trace();
        assertThat(environment.picture()).isCloseTo(luminance(alone) / luminance(picture), within(1e-5));
        assertThat(of(scene, new Contributions.Region(0, 0, 5, 5)).environment()).isEmpty();
    }

    private static double luminance(Film film) {
        return Contributions.Region.all(film).luminance(film);
    }
}
