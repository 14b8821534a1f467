package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
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
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Tests light contributions against the reference. */
@Slow
class LightContributionsTest {
    private static final RenderOptions OPTIONS = new RenderOptions(Accuracy.EXACT, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1);

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.sessions();
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void imageWithoutLight_matchesReference(@ForAll("sessions") EditSession session) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            Scene scene = session.scenes().getLast();
            renderer.render(scene, Progress.NONE);
            Film picture = renderer.film().copy();
            ReferenceTracer sampled = new ReferenceTracer(scene);
            LightContributions found = LightContributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT,
                    LightContributions.Region.ofFilm(picture), Progress.NONE);
            assertThat(found.lights()).extracting(LightContribution::light).isEqualTo(Contribution.sources(scene));
            for (LightContribution one : found.lights()) {
                boolean isSolo = one.light().light(scene).filter(light -> scene.rig().effectiveLight(light).solo()).isPresent();
                // Without the only solo light, others would shine.
                if (one.shines() && one.light() instanceof SceneElement.OfLight && !isSolo) {
                    Film filmOff = new ReferenceTracer(LightContributions.switchOff(scene, List.of(one.light()))).trace(sampled);
                    assertThat(one.changeWhenOff())
                            .isEqualTo(FilmChange.between(picture, filmOff, ViewTransform.DEFAULT));
                    assertThat(one.regionShare()).isEqualTo(one.imageShare());
                }
            }
            LightShares shares = LightShares.of(renderer.cache(), OPTIONS, Progress.NONE);
            assertThat(Contribution.sources(scene)).extracting(shares::of).as("the mixer's shares")
                    .containsExactlyElementsOf(found.lights().stream().map(LightContribution::imageShare).toList());
            Film dark = new ReferenceTracer(LightContributions.switchOff(scene, found.idleLights())).trace(sampled);
            assertThat(FilmChange.between(picture, dark, ViewTransform.DEFAULT)).isEqualTo(found.changeWhenIdleOff());
            assertThat(found.changeWhenIdleOff().isInvisible()).isTrue();
            assertThat(renderer.film().hasSameBits(picture)).as("the picture stays").isTrue();
        }
    }

    @Test
    void change_isCountedWhereItIsNoticed() {
        Film before = Film.ofScanlines(4, 1, new float[] {0.5f, 0.5f, 0.5f, 0.2f, 0.2f, 0.2f, 0.1f, 0.1f, 0.1f, 0, 0, 0});
        Film after = Film.ofScanlines(4, 1, new float[] {0.25f, 0.25f, 0.25f, 0.2001f, 0.2f, 0.2f, 0.1f, 0.1f, 0.1f, 1e-7f, 0, 0});
        FilmChange change = FilmChange.between(before, after, ViewTransform.DEFAULT);
        assertThat(change.changedValues()).isEqualTo(5);
        assertThat(change.noticedShare()).isEqualTo(0.25);
        assertThat(change.noticedStops()).isCloseTo(-1, Offset.offset(0.01));
        assertThat(FilmChange.between(after, before, ViewTransform.DEFAULT).noticedStops()).isCloseTo(1,
                Offset.offset(0.01));
    }

    /** The only light of a black world adds all of the picture, indirect light included. */
    @Test
    void indirectLight_countsToItsLight() {
        Scene studio = StudioScene.of(LightType.SPOT);
        Scene scene = IndirectScenes.with(studio.withWorld(new World(0, Rgb.BLACK))
                .withLights(List.of(studio.light(StudioScene.KEY).orElseThrow())));
        Film direct = new ReferenceTracer(scene.withPicture(scene.picture().withIndirect(Optional.empty()))).trace();
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            LightContributions.Region all = LightContributions.Region.ofFilm(direct);
            assertThat(all.luminance(renderer.film())).isGreaterThan(1.01 * all.luminance(direct));
            LightContribution found =
                    LightContributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT, all, Progress.NONE).lights().getFirst();
            assertThat(found.imageShare()).isEqualTo(1);
            Film black = Film.black(direct.width(), direct.height());
            assertThat(found.changeWhenOff())
                    .isEqualTo(FilmChange.between(renderer.film(), black, ViewTransform.DEFAULT));
        }
    }

    private static LightContributions of(Scene scene, LightContributions.Region region) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return LightContributions.of(renderer.cache(), OPTIONS, ViewTransform.DEFAULT, region, Progress.NONE);
        }
    }

    private static LightShares shares(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return LightShares.of(renderer.cache(), OPTIONS, Progress.NONE);
        }
    }

    @Test
    void scaledShares_areThoseOfTheEditedPicture() {
        Scene scene = IndirectScenes.with(StudioScene.withFourLights(30, 24));
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        for (Light edited : List.of(key.withIntensity(key.intensity() / 64), key.withIntensity(3 * key.intensity()), key.withOn(false),
                key.withColor(new Rgb(0.1, 0.9, 0.4)), key.withSolo(true))) {
            LightShares scaled = shares(scene).in(scene.withLight(edited)).orElseThrow();
            LightShares exact = shares(scene.withLight(edited));
            for (Contribution light : Contribution.sources(scene)) {
                assertThat(scaled.of(light)).as("%s after %s", light, edited).isCloseTo(exact.of(light), within(1e-5));
            }
        }
    }

    @Test
    void scaledShares_areUnknownAfterOtherEdits() {
        Scene scene = StudioScene.withFourLights(30, 24);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        LightShares shares = shares(scene);
        assertThat(shares.in(scene)).isPresent();
        assertThat(shares.in(scene.withLight(key.withPosition(new Vec3(1, 7, 2))))).isEmpty();
        assertThat(shares.in(scene.withLights(List.of(key)))).isEmpty();
        assertThat(shares.in(scene.withWorld(scene.world().withBackground(Rgb.WHITE)))).isEmpty();
        assertThat(shares(scene.withLight(key.withOn(false))).in(scene)).as("a dark light comes on").isEmpty();
    }

    @Test
    void sharesOfAllLights_addUpToOne() {
        Scene scene = StudioScene.of(LightType.POINT);
        Scene lit = scene.withWorld(scene.world().withAmbience(0).withBackground(Rgb.BLACK));
        LightContributions found = of(lit, new LightContributions.Region(0, 0, 5, 5));
        assertThat(found.lights().stream().mapToDouble(LightContribution::imageShare).sum()).isCloseTo(1, within(1e-6));
        assertThat(found.lights()).extracting(LightContribution::regionShare)
                .isNotEqualTo(found.lights().stream().map(LightContribution::imageShare).toList());
    }

    @Test
    void invisibleLights_areIdle() {
        Scene scene = StudioScene.of(LightType.POINT);
        Light key = scene.light(StudioScene.KEY).orElseThrow();
        List<Light> lights = new java.util.ArrayList<>(scene.lights());
        lights.add(key.withName("dim").withIntensity(1e-7));
        lights.add(key.withName("far below").withPosition(new Vec3(0, -1e6, 0)));
        lights.add(key.withName("off").withOn(false));
        LightContributions found = of(scene.withLights(lights), new LightContributions.Region(0, 0, 1, 1));
        assertThat(found.idleLights()).contains(light("dim")).doesNotContain(light(StudioScene.KEY), light("off"));
        assertThat(found.lights().stream().filter(c -> c.light().equals(light("off"))).findFirst().orElseThrow().shines()).isFalse();
    }

    /**
     * White wall that both lights hit at normal incidence, so that all pixels show both: 0.5/255/12.92 is the smallest value
     * displayed as 1.
     */
    @Test
    void lightsVisibleOnlyTogether_areNotBothIdle() throws Exception {
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
        LightContributions found = of(scene, new LightContributions.Region(0, 0, 1, 1));
        assertThat(found.lights()).allMatch(one -> one.changeWhenOff().isInvisible() && !one.changeWhenOff().isNone());
        assertThat(found.idleLights()).containsExactly(light("b"));
    }

    @Test
    void environmentShare_isLossWithoutIt() {
        Scene scene = StudioScene.of(LightType.POINT);
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, 0.5f);
        World around = scene.world().withAmbience(0).withEnvironment(Optional.of(new Environment("sky.hdr", new EnvironmentMap(8, 4, rgb))))
                .withOwn(own -> own.withLightCount(6));
        Scene lit = scene.withWorld(around);
        LightContribution environment = of(lit, new LightContributions.Region(0, 0, 5, 5)).lights().getLast();
        Film picture = new ReferenceTracer(lit).trace();
        Film filmOff = new ReferenceTracer(scene.withWorld(World.INTENSITY.with(around, 0.0))).trace();
        assertThat(environment.light()).isEqualTo(Contribution.ENVIRONMENT);
        assertThat(environment.shines()).isTrue();
        assertThat(environment.changeWhenOff()).isEqualTo(FilmChange.between(picture, filmOff, ViewTransform.DEFAULT));
        Film alone = new ReferenceTracer(LightContributions.switchOff(lit, Contribution.sources(scene))).trace();
        assertThat(environment.imageShare()).isCloseTo(luminance(alone) / luminance(picture), within(1e-5));
        assertThat(of(scene, new LightContributions.Region(0, 0, 5, 5)).lights()).hasSameSizeAs(scene.lights());
        // Lights that its solo darkens stay dark while its share is measured.
        LightContribution solo =
                of(scene.withWorld(World.SOLO.with(around, true)), new LightContributions.Region(0, 0, 5, 5)).lights().getLast();
        assertThat(solo.imageShare()).isCloseTo(1, within(1e-6));
    }

    /** A dome that is twice as bright as the same sky loses twice as much. */
    @Test
    void environments_haveTheirOwnShares() {
        Scene scene = JenScenes.withSky(JenScenes.of("picture { size 20 16 }  camera { from 0 1 6  to 0 1 0 }  world { ambience 0 }"
                + "  sphere ball { at 0 1 0 }  light environment point { at 0 3 1 }"));
        Scene lit = scene.withWorld(scene.world().withNamed(List.of(JenScenes.dome("studio", 2))));
        List<LightContribution> found = of(lit, new LightContributions.Region(0, 0, 5, 5)).lights();
        assertThat(found).extracting(one -> one.light().name(lit)).containsExactly("environment", "environment 2", "studio");
        assertThat(found.get(2).imageShare()).isCloseTo(2 * found.get(1).imageShare(), within(1e-5));
        assertThat(found.stream().mapToDouble(LightContribution::imageShare).sum()).isCloseTo(1, within(1e-5));
    }

    private static Contribution light(String name) {
        return new SceneElement.OfLight(name);
    }

    private static double luminance(Film film) {
        return LightContributions.Region.ofFilm(film).luminance(film);
    }
}
