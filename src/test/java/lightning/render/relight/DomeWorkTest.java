package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.relight.paper.MirrorStorage;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Tests of pictures with several environments, and of the work of their edits. */
class DomeWorkTest {
    private static final Environment EAST = smooth(0.1f, 11);
    private static final Environment WEST = smooth(0.3f, 7);
    private static final Environment SUNNY = withSun();

    private static Environment smooth(float least, int period) {
        float[] rgb = new float[3 * 64 * 32];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = least + i % period * 0.05f;
        }
        return new Environment("sky" + period + ".hdr", new EnvironmentMap(64, 32, rgb));
    }

    private static Environment withSun() {
        float[] rgb = new float[3 * 64 * 32];
        Arrays.fill(rgb, 0.2f);
        Arrays.fill(rgb, 3 * (6 * 64 + 40), 3 * (6 * 64 + 41), 200);
        return new Environment("sun.hdr", new EnvironmentMap(64, 32, rgb));
    }

    /** Returns a studio with domes alone: no other light, no ambience and no color behind it. */
    private static Scene scene(Dome... domes) {
        Scene studio = StudioScene.of(LightType.POINT);
        return studio.withLights(List.of()).withWorld(studio.world().withAmbience(0).withNamed(List.of(domes)));
    }

    private static Dome dome(String name, Environment image) {
        return Dome.of(name).withImage(Optional.of(image));
    }

    private static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    private static void assertSum(Film both, Film a, Film b) {
        float[] sum = both.toScanlines();
        float[] first = a.toScanlines();
        float[] second = b.toScanlines();
        for (int i = 0; i < sum.length; i++) {
            assertThat(sum[i]).isCloseTo(first[i] + second[i], Offset.offset(2e-5f * (1 + sum[i])));
        }
    }

    /**
     * Compares sums of the same films in another order. Each of at most 8 additions and products of values ≥ 0 loses at most half a unit of
     * 2⁻²³, in both pictures.
     */
    private static void assertSameApartFromRounding(Film film, Film expected) {
        float[] a = film.toScanlines();
        float[] b = expected.toScanlines();
        for (int i = 0; i < a.length; i++) {
            assertThat(a[i]).isCloseTo(b[i], Offset.offset(8 * 0x1p-23f * b[i]));
        }
    }

    @Test
    void halfOfAnImageTwice_isTheWholeApartFromRounding() {
        Dome whole = dome("whole", EAST);
        Film expected = film(scene(whole));
        Film halves = film(scene(whole.withName("a").withIntensity(0.5), whole.withName("b").withIntensity(0.5)));
        assertSameApartFromRounding(halves, expected);
        assertThat(expected.red(0, 0)).isPositive();
    }

    @Test
    void singleDome_equalsTheEnvironmentOfTheWorldInEveryBit() {
        Dome dome = dome("sky", SUNNY).withRotation(DomeRotation.of(30, 10, 5)).withIntensity(1.3).withGain(0.7).withLightCount(5)
                .withSoftness(0.4);
        World own = World.DEFAULT.withAmbience(0).withOwn(it -> it.withImage(dome.image()).withRotation(dome.rotation()).withIntensity(1.3)
                .withGain(0.7).withLightCount(5).withSoftness(0.4));
        Scene scene = scene(dome);
        FilmAssert.assertSameBits(film(scene), film(scene.withWorld(own)), "dome-single");
    }

    @Test
    void pictureOfTwoDomes_isTheSumOfEach() {
        Dome east = dome("east", EAST).withGain(2);
        Dome sunny = dome("sunny", SUNNY).withRotation(DomeRotation.of(70, 20, 0)).withIntensity(0.6);
        assertSum(film(scene(east, sunny)), film(scene(east)), film(scene(sunny)));
    }

    @Test
    void domeAndOwnEnvironment_addUp() {
        Scene dome = scene(dome("west", WEST));
        Scene own = scene().withWorld(scene().world().withOwn(it -> it.withImage(Optional.of(EAST))));
        assertSum(film(own.withWorld(own.world().withNamed(dome.world().named()))), film(own), film(dome));
    }

    @Test
    void orderOfTwoDomes_changesOnlyRounding() {
        Dome east = dome("east", EAST);
        Dome west = dome("west", WEST).withIntensity(0.3).withRotation(DomeRotation.of(45, 0, 0));
        assertSameApartFromRounding(film(scene(east, west)), film(scene(west, east)));
    }

    @Test
    void domeThatIsOff_isNeitherSeenNorLights() {
        Dome east = dome("east", EAST);
        Dome off = dome("off", SUNNY).withOn(false);
        FilmAssert.assertSameBits(film(scene(east, off)), film(scene(east)), "dome-off");
    }

    @Test
    void colorBehindTheScene_isSeenWhereAllDomesAreOff() {
        Scene red = scene(dome("off", SUNNY).withOn(false));
        Film film = film(red.withWorld(red.world().withBackground(new Rgb(0.5, 0, 0))));
        assertThat(film.red(0, 0)).isEqualTo(0.5f);
        assertThat(film.green(0, 0)).isZero();
    }

    /** Its image stays visible, as that of an environment that a solo mutes does. */
    @Test
    void soloDome_mutesTheLightOfOthers() {
        Dome east = dome("east", EAST).withSolo(true);
        Dome sunny = dome("sunny", SUNNY);
        FilmAssert.assertSameBits(film(scene(east, sunny)), film(scene(east, sunny.withGain(0))), "dome-solo");
    }

    @Test
    void dome_withoutAnImage_hasNoEffect() {
        FilmAssert.assertSameBits(film(scene(Dome.of("empty"))), film(scene()), "dome-empty");
    }

    private static UpdateResult edit(StudioRenderer studio, UnaryOperator<Dome> change) {
        World world = studio.scene().world();
        UpdateResult update = studio.render(studio.scene().withWorld(world.withDome("b", change.apply(world.dome("b").orElseThrow()))));
        FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "dome-edit");
        return update;
    }

    @Test
    void editsOfOneDome_castNoRays() {
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS,
                scene(dome("a", SUNNY), dome("b", WEST)))) {
            List<UnaryOperator<Dome>> edits = List.of(d -> d.withIntensity(0.4), d -> d.withGain(3), d -> d.withIntensity(0),
                    d -> d.withIntensity(2), d -> d.withRotation(DomeRotation.of(30, 0, 0)),
                    d -> d.withRotation(DomeRotation.of(30, 20, 9)),
                    d -> d.withImage(Optional.of(EAST)), d -> d.withSolo(true), d -> d.withSolo(false), d -> d.withOn(false),
                    d -> d.withOn(true));
            for (UnaryOperator<Dome> edit : edits) {
                assertThat(edit(studio, edit).rays().total()).isZero();
            }
        }
    }

    /** Only the lights of its bright parts cast shadow rays, as those of a single environment do. */
    @Test
    void turnedDomeWithASun_castsTheShadowRaysOfItsSunAlone() {
        Scene alone = scene(dome("b", SUNNY));
        long expected;
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, alone)) {
            expected = edit(studio, d -> d.withRotation(DomeRotation.of(40, 0, 0))).rays().total();
        }
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS,
                scene(dome("a", SUNNY), dome("b", SUNNY)))) {
            assertThat(edit(studio, d -> d.withRotation(DomeRotation.of(40, 0, 0))).rays().total()).isEqualTo(expected).isPositive();
        }
    }

    @Test
    void removedDome_castsNoRays() {
        try (StudioRenderer studio = new StudioRenderer(ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS,
                scene(dome("a", SUNNY), dome("b", WEST)))) {
            World world = studio.scene().world();
            UpdateResult update = studio.render(studio.scene().withWorld(world.withNamed(world.named().subList(0, 1))));
            assertThat(update.rays().total()).isZero();
            FilmAssert.assertSameBits(studio.renderer().film(), new ReferenceTracer(studio.scene()).trace(), "dome-removed");
        }
    }

    @Test
    void sharesOfDomes_followTheirLight() {
        Scene scene = scene(dome("a", WEST), dome("b", WEST).withIntensity(3));
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            LightShares shares = LightShares.of(renderer.cache(), RenderOptions.DEFAULT, Progress.NONE);
            assertThat(shares.of(new SceneElement.OfDome("a"))).isCloseTo(0.25, Offset.offset(1e-5));
            assertThat(shares.of(new SceneElement.OfDome("b"))).isCloseTo(0.75, Offset.offset(1e-5));
            Scene brighter = scene.withWorld(scene.world().withDome("a", scene.world().named().getFirst().withIntensity(3)));
            assertThat(shares.in(brighter).orElseThrow().of(new SceneElement.OfDome("a"))).isCloseTo(0.5, Offset.offset(1e-5));
        }
    }
}
