package lightning.render.fulltrace;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.sample.IndirectScenes;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Laws of indirect light that follow from its equation, without another renderer. */
class IndirectLightTest {
    /**
     * The filter adds up at most one weight for each of 192 pixels, and again their products with a light of at most 1: each step rounds
     * to 2⁻²⁴ of at most 1. Other sums here are exact.
     */
    private static final float FILTER_ROUNDING = 2 * 192 * 0x1p-24f;
    /**
     * Roundings of a value: at each of at most three bounces 64 rays and 6 factors, then a filter of at most 256 points with its weights,
     * eight points of a row, and 20 at each of five levels.
     */
    private static final double SUM_ROUNDING = (3 * 70 + 2 * 256 + 16 + 100) * 0x1p-24;

    private static Film trace(Scene scene) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(scene).trace(workers, Progress.NONE).film();
        }
    }

    /** Every ray meets the same light, so after n bounces a wall of albedo ρ and glow 1 shows 1 + ρ + … + ρⁿ. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void glowingShell_showsGeometricSeries(int bounces) throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 16 12  depth 0 }
                camera { from 0.2 0.1 0.3  to 0 0 -1 }
                material shell { diffuse 0.5 0.25 0  glow 1 1 1 }
                sphere around { material shell  scale 2 2 2 }
                """, "shell.jen", Path.of("")).scene();
        Film film = trace(scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(bounces, 16, 4, false)))));
        for (int i = 0; i < 16 * 12; i++) {
            assertThat(film.red(i % 16, i / 16)).isCloseTo(series(0.5f, bounces), within(FILTER_ROUNDING));
            assertThat(film.green(i % 16, i / 16)).isCloseTo(series(0.25f, bounces), within(FILTER_ROUNDING));
            assertThat(film.blue(i % 16, i / 16)).isEqualTo(1);
        }
    }

    private static float series(float albedo, int bounces) {
        float sum = 1;
        for (int bounce = 0; bounce < bounces; bounce++) {
            sum = 1 + albedo * sum;
        }
        return sum;
    }

    /** Doubling is exact in floats, so every value doubles exactly. */
    @ParameterizedTest
    @ValueSource(strings = {"room", "mirror ball", "glass ball", "two rooms with a thin wall"})
    void doubledLights_doubleThePicture(String name) {
        Scene scene = withoutBackground(IndirectScenes.all().get(name));
        Film once = trace(scene);
        Film twice = trace(scene.withLights(scene.lights().stream().map(l -> l.withIntensity(2 * l.intensity())).toList()));
        float[] expected = once.toScanlines();
        for (int i = 0; i < expected.length; i++) {
            expected[i] *= 2;
        }
        assertThat(twice.toScanlines()).isEqualTo(expected);
    }

    /** Each value is a sum of products of values of at least 0, so roundings add up relative to the value. */
    @ParameterizedTest
    @ValueSource(strings = {"room", "mirror ball", "glass ball", "textures"})
    void twoLights_giveTheSumOfTheirPictures(String name) {
        Scene scene = withoutBackground(IndirectScenes.all().get(name));
        Light other = scene.lights().getFirst().withName("second").withPosition(new Vec3(-0.6, 0.3, 0.5)).withColor(new Rgb(0.3, 0.9, 2));
        float[] first = trace(scene).toScanlines();
        float[] second = trace(scene.withLights(List.of(other))).toScanlines();
        float[] both = trace(scene.withLights(List.of(scene.lights().getFirst(), other))).toScanlines();
        for (int i = 0; i < both.length; i++) {
            double sum = (double) first[i] + second[i];
            assertThat((double) both[i]).isCloseTo(sum, within(SUM_ROUNDING * (both[i] + sum)));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"room", "glass ball"})
    void lightThatIsOff_isAbsent(String name) {
        Scene scene = IndirectScenes.all().get(name);
        Scene without = scene.withLights(List.of());
        Scene off = scene.withLights(scene.lights().stream().map(l -> l.withOn(false)).toList());
        assertThat(trace(off).hasSameBits(trace(without))).isTrue();
    }

    /** The wall has no thickness. Light on one side of it must not reach the other side. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void thinWall_keepsOtherRoomDark(int bounces) throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 40 20  depth 0 }
                camera { from 0 0 0.9  to 0 0 -1  fov 90 }
                material white { diffuse 0.8 0.8 0.8 }
                plane floor { material white  at 0 -1 0  scale 2 1 2 }
                plane ceiling { material white  at 0 1 0  scale 2 1 2 }
                plane back { material white  at 0 0 -1  rotate 90 0 0  scale 2 1 2 }
                plane front { material white  at 0 0 1  rotate 90 0 0  scale 2 1 2 }
                plane left { material white  at -1 0 0  rotate 0 0 90  scale 2 1 2 }
                plane right { material white  at 1 0 0  rotate 0 0 90  scale 2 1 2 }
                plane wall { material white  at 0.01 0 0  rotate 0 0 90  scale 2 1 2 }
                light lamp point { at 0.6 0.5 0 }
                """, "rooms.jen", Path.of("")).scene();
        Film film = trace(scene.withPicture(scene.picture().withIndirect(Optional.of(new IndirectSettings(bounces, 16, 4, false)))));
        double brightest = 0;
        for (int i = 0; i < 40 * 20; i++) {
            brightest = Math.max(brightest, film.red(i % 40, i / 40));
        }
        // The camera is in the left room.
        assertThat(brightest).isZero();
    }

    /**
     * The picture shows both rooms, seen along the wall. Cells of surfels are aligned with a wall at 0; those on both sides of the foot of
     * another wall carry a little light: three times what was measured is allowed.
     */
    @ParameterizedTest
    @CsvSource({"0, 0", "0.03, 0.09"})
    void thinWallSeenAlongIt_keepsOtherRoomDark(double wall, double allowed) throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 80 60  depth 0  indirect { bounces 2  rays 64  spacing 8 } }
                camera { from 0.1 1.3 5.2  to 0.1 1.1 0  fov 50 }
                world { ambience 0 }
                material white { diffuse 0.7 0.7 0.7 }
                plane floor { material white  at 0 0 0  scale 6 1 5 }
                plane ceiling { material white  at 0 2.4 0  scale 6 1 5 }
                plane back { material white  at 0 1.2 -2.5  rotate 90 0 0  scale 6 1 2.4 }
                plane front { material white  at 0 1.2 2.5  rotate 90 0 0  scale 6 1 2.4  visible no }
                plane left { material white  at -3 1.2 0  rotate 0 0 90  scale 2.4 1 5 }
                plane right { material white  at 3 1.2 0  rotate 0 0 90  scale 2.4 1 5 }
                light lamp point { at -1.5 1.9 0  intensity 3  falloff inverse_square }
                """ + "plane wall { material white  at " + wall + " 1.2 0  rotate 0 0 90  scale 2.4 1 5 }\n", "rooms.jen", Path.of(""))
                .scene();
        float[] direct = trace(IndirectScenes.without(scene)).toScanlines();
        float[] all = trace(scene).toScanlines();
        double lit = 0;
        double leaked = 0;
        int litCount = 0;
        for (int i = 0; i < all.length; i++) {
            // The lamp lights every visible place of its own room.
            if (direct[i] > 0) {
                lit += all[i];
                litCount++;
            } else {
                leaked = Math.max(leaked, all[i]);
            }
        }
        assertThat(leaked / (lit / litCount)).isBetween(0.0, allowed);
    }

    /**
     * A plain room with a patch of sunlight: gather points near edges are small and their few rays see the patch or miss it. The filter must
     * average enough of them. With a reach of two radii, 5 % of the pixels differed by more than 36 % from 1024 rays.
     */
    @Test
    void edgesOfPlainWalls_haveLittleNoise() throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 160 120  depth 0  indirect { bounces 2  rays 64  spacing 8 } }
                camera { from 2.2 1.4 2.6  to -1 1 -1  fov 60 }
                world { ambience 0  background 0 0 0 }
                material white { diffuse 0.8 0.8 0.8 }
                plane floor { material white  at 0 0 0.2  scale 5 1 5.4 }
                plane ceiling { material white  at 0 2.5 0.2  scale 5 1 5.4 }
                plane back { material white  at 0 1.25 -2.5  rotate 90 0 0  scale 5 1 2.5 }
                plane front { material white  at 0 1.25 2.9  rotate 90 0 0  scale 5 1 2.5 }
                plane right { material white  at 2.5 1.25 0.2  rotate 0 0 90  scale 2.5 1 5.4 }
                plane below { material white  at -2.5 0.45 0.2  rotate 0 0 90  scale 0.9 1 5.4 }
                plane above { material white  at -2.5 2.2 0.2  rotate 0 0 90  scale 0.6 1 5.4 }
                plane side { material white  at -2.5 1.4 -1.5  rotate 0 0 90  scale 1 1 2 }
                plane other_side { material white  at -2.5 1.4 1.6  rotate 0 0 90  scale 1 1 2.6 }
                light sun directional { direction 1 -0.75 0.15  intensity 6 }
                """, "room.jen", Path.of("")).scene();
        IndirectSettings settings = scene.picture().indirect().orElseThrow();
        float[] direct = trace(IndirectScenes.without(scene)).toScanlines();
        float[] few = trace(scene).toScanlines();
        float[] many = trace(scene.withPicture(scene.picture().withIndirect(Optional.of(settings.withRays(1024))))).toScanlines();
        double[] errors = IntStream.range(0, few.length).filter(i -> direct[i] == 0 && many[i] > 0)
                .mapToDouble(i -> Math.abs(few[i] / many[i] - 1)).sorted().toArray();
        assertThat(errors[errors.length * 95 / 100]).isLessThan(0.32);
    }

    /** A floor below a large roof, under a white background. */
    private static Film floorUnder(String roof) throws JenException {
        return trace(JenReader.read("""
                jen 1
                picture { size 16 12  depth 2  indirect { bounces 1  rays 256  spacing 4  background on } }
                camera { from 0 0.8 0  to 0 0 0  up 0 0 -1  fov 40 }
                world { ambience 0  background 1 1 1 }
                material white { diffuse 0.5 0.5 0.5 }
                plane floor { material white }
                """ + roof, "floor.jen", Path.of("")).scene());
    }

    private static float[] valuesUnder(String roof) throws JenException {
        return floorUnder(roof).toScanlines();
    }

    /** The roof covers all rays but those within 0.002 radians of the horizon, to which a stratum of the rays belongs only in part. */
    private static final String ROOF = "plane roof { material r  at 0 1 0  scale 1000 1 1000 }\n";

    /** Every ray passes the same surface and keeps 1 − 0.9 of its light. Each mean rounds as in {@link #FILTER_ROUNDING}. */
    @Test
    void reflectivePane_passesTheRest() throws JenException {
        float[] under = valuesUnder("material r { diffuse 0 0 0  clear 1 1 1  ior 1  reflective 0.9 0.9 0.9  thin yes }\n" + ROOF);
        float passed = (1 - 0.9f) * 1;
        for (float value : under) {
            assertThat(value).isCloseTo(0.5f * passed, within(FILTER_ROUNDING));
        }
    }

    /**
     * A thin sheet passes (1 − F)/(1 + F), which falls with the angle. The 256 rays are stratified in 16 rings of equal weight, and no ring
     * differs from its mean by more than the values at its edges do: all together by at most 1/16 of the range, which is 0…1.
     */
    @Test
    void clearPane_passesWhatFresnelsEquationsLeave() throws JenException {
        float[] under = valuesUnder("material r { diffuse 0 0 0  clear 1 1 1  ior 1.5  thin yes }\n" + ROOF);
        int steps = 1000;
        double passed = 0;
        for (int i = 0; i < steps; i++) {
            double cosine = Math.sqrt((i + 0.5) / steps);
            double refracted = Math.sqrt(1 - (1 - cosine * cosine) / 2.25);
            double s = (cosine - 1.5 * refracted) / (cosine + 1.5 * refracted);
            double p = (refracted - 1.5 * cosine) / (refracted + 1.5 * cosine);
            double f = (s * s + p * p) / 2;
            passed += (1 - f) / (1 + f) / steps;
        }
        assertThat(passed).isBetween(0.84, 0.86);
        for (float value : under) {
            assertThat((double) value).isCloseTo(0.5 * passed, within(0.5 / 16));
        }
    }

    /** The face of a light hides nothing from indirect light, whatever the light's intensity is. */
    @ParameterizedTest
    @ValueSource(strings = {"rect { at 0 1 0  direction 0 -1 0  width 40  height 40", "point { at 0 3 0  radius 2"})
    void visibleLight_blocksNoSky(String light) throws JenException {
        String text = "light l " + light + "  intensity 0  samples 4  visible ";
        assertThat(valuesUnder(text + "yes }\n")).isEqualTo(valuesUnder(text + "no }\n")).isEqualTo(valuesUnder(""));
    }

    /** Without a limit on the right side, the last panes let the background into the closed room. */
    @ParameterizedTest
    @ValueSource(ints = {17, 100, 300})
    void closedRoomBehindPanes_staysDark(int panes) throws JenException {
        String all = IntStream.range(0, panes).mapToObj(i -> "plane p" + i + " { material pane  at " + (0.2 + 0.8 * i / panes)
                + " 0 0  rotate 0 0 90  scale 1.9 1 3.9 }\n").collect(Collectors.joining());
        Film film = trace(JenReader.read("""
                jen 1
                picture { size 16 12  depth 2  indirect { bounces 1  rays 64  spacing 4  background on } }
                camera { from -0.9 0 0  to -0.5 -1 0  fov 60 }
                world { ambience 0  background 1 1 1 }
                material white { diffuse 0.8 0.8 0.8 }
                material pane { diffuse 0 0 0  clear 1 1 1  ior 1  thin yes }
                plane floor { material white  at 0 -1 0  scale 4 1 4 }
                plane ceiling { material white  at 0 1 0  scale 4 1 4 }
                plane back { material white  at 0 0 -2  rotate 90 0 0  scale 4 1 2 }
                plane front { material white  at 0 0 2  rotate 90 0 0  scale 4 1 2 }
                plane left { material white  at -2 0 0  rotate 0 0 90  scale 2 1 4 }
                plane right { material white  at 2 0 0  rotate 0 0 90  scale 2 1 4 }
                """ + all, "panes.jen", Path.of("")).scene());
        assertThat(film.toScanlines()).containsOnly(0);
    }

    /** The shadows of an object are those of lights. Rays of indirect light meet all objects but those that are clear. */
    @Test
    void shadowsOfMaterials_concernLightsOnly() throws JenException {
        assertThat(valuesUnder("material r { diffuse 0 0 0  shadows none }\n" + ROOF))
                .isEqualTo(valuesUnder("material r { diffuse 0 0 0  shadows full }\n" + ROOF)).isNotEqualTo(valuesUnder(""));
        assertThat(valuesUnder("material r { diffuse 0 0 0  clear 1 1 1  ior 1  thin yes  shadows full }\n" + ROOF))
                .isEqualTo(valuesUnder(""));
    }

    /** A mirror's light is not traced further, so a mirror around a floor takes all light from it. */
    @Test
    void mirror_absorbsIndirectLight() throws JenException {
        assertThat(valuesUnder("material r { diffuse 0.8 0.8 0.8  reflective 1 1 1 }\n" + ROOF.replace("1000", "1e7"))).containsOnly(0);
    }

    /** Links and gains choose which objects a light reaches directly; light that other objects scatter is that of all lights. */
    @ParameterizedTest
    @ValueSource(strings = {"gains \"ball\" 0", "illuminates only \"floor\""})
    void objectThatALightDoesNotReach_isLitByOtherObjects(String choice) throws JenException {
        Film film = trace(JenReader.read("""
                jen 1
                picture { size 16 12  depth 0  indirect { bounces 1  rays 64  spacing 4 } }
                camera { from 0 0.5 3  to 0 0.5 0  fov 10 }
                world { ambience 0  background 0 0 0 }
                material white { diffuse 0.8 0.8 0.8 }
                plane floor { material white  at 0 -1 0  scale 9 1 9 }
                sphere ball { material white  at 0 0.5 0 }
                """ + "light lamp point { at 3 3 3  " + choice + " }\n", "links.jen", Path.of("")).scene());
        assertThat(film.red(8, 6)).isPositive();
    }

    private static Scene withoutBackground(Scene scene) {
        return scene.withWorld(new World(0, Rgb.BLACK));
    }
}
