package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.sample.IndirectScenes;
import lightning.sample.JenScenes;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import lightning.scene.AntialiasMode;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Slow
class LightMatchTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withThreads(1);
    private static final MatchSettings COLORS =
            new MatchSettings(Optional.empty(), Set.of(MatchChange.COLORS), MatchSettings.Reference.FIXED, MatchSettings.Reference.FIXED,
                    0);
    private static final MatchSettings FREE_EXPOSURE =
            new MatchSettings(Optional.empty(), Set.of(), MatchSettings.Reference.FREE, MatchSettings.Reference.FIXED, 0);
    private static final MatchSettings FREE_WHITE =
            new MatchSettings(Optional.empty(), Set.of(), MatchSettings.Reference.FIXED, MatchSettings.Reference.FREE, 0);

    /** A rig of up to eight lights around the studio, whose intensities were multiplied by up to ten or divided by it. */
    @Property(tries = 100)
    void changedIntensities_comeBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = rig(random);
        List<Double> factors = new ArrayList<>();
        Scene changed = scene;
        for (Light light : scene.lights()) {
            double factor = Math.exp((2 * random.nextDouble() - 1) * Math.log(10));
            factors.add(factor);
            changed = changed.withLight(light.withIntensity(light.intensity() * factor));
        }
        MatchResult result = match(scene, film(changed), MatchSettings.DEFAULT);
        assertThat(result.errorAfter()).isLessThan(1e-5);
        for (LightFactor found : result.factors()) {
            if (!isAmbiguous(result, found.light())) {
                assertThat(found.isGray()).isTrue();
                double wanted = factors.get(index(scene, found.light()));
                assertThat(found.red()).as("%s of %s", found.light(), scene.lights()).isCloseTo(wanted, within(1e-3 * wanted));
            }
        }
    }

    @Property(tries = 20)
    void changedColors_comeBack(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = rig(random);
        Scene changed = scene;
        for (Light light : scene.lights()) {
            changed = changed.withLight(light.withIntensity(light.intensity() * (0.3 + 2 * random.nextDouble()))
                    .withColor(new Rgb(0.2 + 0.8 * random.nextDouble(), 0.2 + 0.8 * random.nextDouble(), 1)));
        }
        MatchResult result = match(scene, film(changed), COLORS);
        Scene matched = MatchedScene.of(scene, result);
        for (LightFactor found : result.factors()) {
            if (!isAmbiguous(result, found.light())) {
                Light wanted = found.light().light(changed).orElseThrow();
                Rgb light = found.light().light(matched).orElseThrow().color()
                        .times(found.light().light(matched).orElseThrow().intensity());
                Rgb expected = wanted.color().times(wanted.intensity());
                assertThat(light.r()).isCloseTo(expected.r(), within(1e-3 * expected.r()));
                assertThat(light.g()).isCloseTo(expected.g(), within(1e-3 * expected.g()));
                assertThat(light.b()).isCloseTo(expected.b(), within(1e-3 * expected.b()));
            }
        }
    }

    /** Indirect light and mirrors belong to the lights that they come from. */
    @Test
    void indirectLight_isMatched() {
        Scene scene = IndirectScenes.with(StudioScene.withFourLights(40, 32));
        Light fill = scene.light("fill").orElseThrow();
        MatchResult result = match(scene, film(scene.withLight(fill.withIntensity(3 * fill.intensity()))), MatchSettings.DEFAULT);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(f.light().equals(light("fill")) ? 3 : 1, within(1e-3)));
    }

    @Test
    void brighterReference_withFreeExposure_changesNothing() {
        Scene scene = dark(StudioScene.withFourLights(40, 32));
        MatchResult result = match(scene, scaled(film(scene), 7, 7, 7), FREE_EXPOSURE);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(1, within(1e-3)));
        assertThat(result.exposure()).allSatisfy(e -> assertThat(e).isCloseTo(1 / 7.0, within(1e-4)));
        assertThat(result.errorBefore()).isLessThan(1e-5);
    }

    @Test
    void tintedReference_withFreeWhite_changesNothing() {
        Scene scene = dark(StudioScene.withFourLights(40, 32));
        MatchResult result = match(scene, scaled(film(scene), 2, 1, 0.5f), FREE_WHITE);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(1, within(1e-3)));
        assertThat(result.exposure().get(2) / result.exposure().get(0)).isCloseTo(4, within(1e-3));
    }

    @Test
    void referenceWithoutALight_switchesItOff() {
        Scene scene = StudioScene.withFourLights(40, 32);
        MatchResult result = match(scene, film(scene.withLight(scene.light("sun").orElseThrow().withOn(false))), MatchSettings.DEFAULT);
        assertThat(result.factors()).anySatisfy(f -> {
            assertThat(f.light()).isEqualTo(light("sun"));
            assertThat(f.red()).isBetween(0.0, 1e-5);
        });
    }

    /** A black reference cannot be reached below the ambient light, and no light becomes negative. */
    @Test
    void blackReference_switchesAllOff() {
        Scene scene = StudioScene.withFourLights(40, 32);
        MatchResult result = match(scene, Film.black(40, 32), MatchSettings.DEFAULT);
        assertThat(result.factors()).hasSize(4).allSatisfy(f -> assertThat(f.red()).isBetween(0.0, 1e-5));
        assertThat(result.errorAfter()).isLessThan(result.errorBefore());
    }

    @Test
    void otherLights_keepTheirIntensity() {
        Scene scene = StudioScene.withFourLights(40, 32);
        Light fill = scene.light("fill").orElseThrow();
        Film reference = film(scene.withLight(fill.withIntensity(2)));
        MatchResult result =
                match(scene, reference, new MatchSettings(Optional.of(Set.of(light("sun"))), Set.of(), MatchSettings.Reference.FIXED,
                        MatchSettings.Reference.FIXED, 0));
        assertThat(result.factors()).extracting(LightFactor::light).containsExactly(light("sun"));
    }

    /** Two lights at the same place differ in nothing that a picture shows. */
    @Test
    void equalLights_areNamed() {
        Scene scene = StudioScene.withFourLights(40, 32);
        Light fill = scene.light("fill").orElseThrow();
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(fill.withName("twin"));
        Scene twins = scene.withLights(lights);
        MatchResult result = match(twins, film(twins.withLight(fill.withIntensity(3 * fill.intensity()))), MatchSettings.DEFAULT);
        assertThat(result.alike()).containsExactly(new MatchResult.LightPair(light("fill"), light("twin")));
        double sum = result.factors().stream().filter(f -> Set.of(light("fill"), light("twin")).contains(f.light()))
                .mapToDouble(LightFactor::red).sum();
        assertThat(sum).isCloseTo(4, within(1e-3));
    }

    @Test
    void lightThatMeetsNothing_isNamed() {
        Scene scene = StudioScene.withFourLights(40, 32);
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(StudioScene.key(LightType.SPOT).withName("away").withPosition(new Vec3(0, 50, 0)).withDirection(Vec3.Y));
        MatchResult result = match(scene.withLights(lights), film(scene), MatchSettings.DEFAULT);
        assertThat(result.unseen()).containsExactly(light("away"));
    }

    /** Only the left half of the reference counts; in the right half it is another picture. */
    @Test
    void pixelsOutsideTheRegion_doNotCount() {
        Scene scene = StudioScene.withFourLights(40, 32);
        Light fill = scene.light("fill").orElseThrow();
        float[] rgb = film(scene.withLight(fill.withIntensity(2 * fill.intensity()))).toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 % 40 < 20 ? rgb[i] : 9;
        }
        ReferenceImage reference = ReferenceImage.of(Film.ofScanlines(40, 32, rgb)).within(0, 0, 0.5, 1);
        MatchResult result = match(scene, reference, MatchSettings.DEFAULT);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(f.light().equals(light("fill")) ? 2 : 1, within(1e-3)));
    }

    @Property(tries = 20)
    void pixelsThatAreNoNumbers_doNotCount(@ForAll long seed) {
        Random random = new Random(seed);
        Scene scene = StudioScene.withFourLights(40, 32);
        Light fill = scene.light("fill").orElseThrow();
        float[] rgb = film(scene.withLight(fill.withIntensity(2 * fill.intensity()))).toScanlines();
        float[] invalid = {Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY};
        BitSet damaged = new BitSet();
        for (int i = 0; i < 100; i++) {
            int value = random.nextInt(rgb.length);
            rgb[value] = invalid[random.nextInt(3)];
            damaged.set(value / 3);
        }
        int larger = 1 + random.nextInt(2);
        ReferenceImage reference = ReferenceImage.of(enlarged(rgb, 40, 32, larger));
        assertThat(reference.invalidPixels()).isEqualTo(larger * larger * damaged.cardinality());
        MatchResult result = match(scene, reference, MatchSettings.DEFAULT);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(f.light().equals(light("fill")) ? 2 : 1, within(1e-3)));
        assertThat(result.errorAfter()).isLessThan(1e-5);
    }

    private static Film enlarged(float[] rgb, int width, int height, int factor) {
        float[] large = new float[factor * factor * rgb.length];
        for (int i = 0; i < large.length; i++) {
            int x = i / 3 % (factor * width) / factor;
            int y = i / 3 / (factor * width) / factor;
            large[i] = rgb[3 * (y * width + x) + i % 3];
        }
        return Film.ofScanlines(factor * width, factor * height, large);
    }

    /** A display shows no value above 1. */
    @Test
    void clippedPixels_doNotCount() {
        Scene scene = StudioScene.withFourLights(40, 32);
        Light fill = scene.light("fill").orElseThrow();
        float[] rgb = film(scene.withLight(fill.withIntensity(4 * fill.intensity()))).toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = Math.min(1, rgb[i]);
        }
        Film clipped = Film.ofScanlines(40, 32, rgb);
        assertThat(match(scene, ReferenceImage.of(clipped).withoutClipped(), MatchSettings.DEFAULT).factors())
                .allSatisfy(f -> assertThat(f.red()).isCloseTo(f.light().equals(light("fill")) ? 4 : 1, within(1e-3)));
    }

    @Test
    void largerReference_isReduced() {
        Scene scene = StudioScene.withFourLights(40, 32);
        float[] rgb = film(scene).toScanlines();
        MatchResult result = match(scene, enlarged(rgb, 40, 32, 2), MatchSettings.DEFAULT);
        assertThat(result.errorBefore()).isLessThan(1e-6);
    }

    /** The paint lies where only one light shines, and asks for one stop more. */
    @Test
    void brightPaint_raisesTheLightThatShinesThere() {
        Scene scene = dark(StudioScene.withFourLights(40, 32));
        List<Light> lights = List.of(scene.light("fill").orElseThrow(), scene.light("back").orElseThrow());
        Scene two = scene.withLights(lights);
        Film left;
        Film right;
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(two, Progress.NONE);
            left = renderer.contribution(new SceneElement.OfLight("fill"), Progress.NONE);
            right = renderer.contribution(new SceneElement.OfLight("back"), Progress.NONE);
        }
        List<BrushDab> dabs = new ArrayList<>();
        for (int i = 0; i < 40 * 32; i++) {
            if (left.red(i % 40, i / 40) > 0.05 && right.red(i % 40, i / 40) == 0) {
                dabs.add(new BrushDab(BrushDab.Wish.BRIGHTER, i % 40 + 0.5, i / 40 + 0.5, 0.6));
            }
        }
        assertThat(dabs).hasSizeGreaterThan(10);
        MatchResult result = match(two, PaintedReference.of(film(two), dabs), new MatchSettings(Optional.empty(), Set.of(),
                MatchSettings.Reference.FIXED, MatchSettings.Reference.FIXED, MatchSettings.PAINTED));
        assertThat(result.factors().get(0).red()).isCloseTo(2, within(0.1));
        assertThat(result.factors().get(1).red()).isCloseTo(1, within(0.1));
    }

    /** Where a light is seen, in its bulb or its face, the picture follows its factor, too. */
    @ParameterizedTest
    @ValueSource(strings = {"material lamp { diffuse 0.2 0.2 0.2  bulb key  shadows none }  sphere s { material lamp  at 0 1 0 }"
            + "  light key point { at 0 3 1  intensity 0.2 }",
        "light key rect { at 0 2 0  direction 0 -0.3 1  width 2  height 2  intensity 0.2  visible yes }",
        "light key point { at 0 1 0  radius 0.5  intensity 0.2  visible yes }"})
    void lightThatIsSeen_isMatched(String key) {
        Scene scene = JenScenes.of("picture { size 24 16 }  camera { from 0 1 6  to 0 1 0 }  world { ambience 0 }"
                + "  plane floor { scale 20 1 20 }  light fill point { at 3 3 3  intensity 0.3 }  " + key);
        Light light = scene.light("key").orElseThrow();
        MatchResult result = match(scene, film(scene.withLight(light.withIntensity(0.4))), MatchSettings.DEFAULT);
        assertThat(result.factors()).allSatisfy(f -> assertThat(f.red()).isCloseTo(f.light().equals(light("key")) ? 2 : 1, within(1e-4)));
        assertThat(result.errorAfter()).isLessThan(1e-5);
    }

    /** Every pixel has the same samples in both. */
    @Test
    void environmentOfAntialiasedPicture_isMatched() {
        Scene studio = JenScenes.withSky(StudioScene.withFourLights(40, 32));
        Scene scene = studio.withPicture(studio.picture().withSampling(new SamplingSettings(AntialiasMode.EVERY, 2)));
        MatchResult result = match(scene, film(scene.withWorld(scene.world().withOwn(own -> own.withIntensity(3)))), MatchSettings.DEFAULT);
        assertThat(result.factors()).allSatisfy(
                f -> assertThat(f.red()).isCloseTo(f.light().equals(Contribution.ENVIRONMENT) ? 3 : 1, within(1e-3)));
    }

    @Test
    void environmentAndDome_areMatchedApart() {
        Scene lamp = JenScenes.withSky(JenScenes.of("picture { size 40 32 }  camera { from 0 2 6  to 0 1 0 }  plane floor { }"
                + "  sphere ball { at 0 1 0 }  light environment point { at 0 3 1 }"));
        Dome studio = JenScenes.dome("studio", 1).withRotation(DomeRotation.NONE.withTilt(150));
        Scene scene = lamp.withWorld(lamp.world().withNamed(List.of(studio)));
        Scene reference = scene.withWorld(scene.world().withOwn(own -> own.withIntensity(0.5)).withNamed(List.of(studio.withIntensity(3))));
        MatchResult result = match(scene, film(reference), MatchSettings.DEFAULT);
        assertThat(result.factors()).extracting(f -> f.light().name(scene)).containsExactly("environment", "environment 2", "studio");
        assertThat(result.factors().get(0).red()).isCloseTo(1, within(0.01));
        assertThat(result.factors().get(1).red()).isCloseTo(0.5, within(0.01));
        assertThat(result.factors().get(2).red()).isCloseTo(3, within(0.01));
        assertThat(MatchedScene.of(scene, result).world().dome("studio").orElseThrow().intensity()).isCloseTo(3, within(0.01));
    }

    /** Each pixel that the light reaches is on an edge and has finer samples. */
    @Test
    void lightOnThinThingsAlone_isMatchedInAntialiasedPicture() throws JenException {
        StringBuilder text = new StringBuilder("""
                jen 1
                picture { size 40 32  antialias edges  depth 0 }
                camera { from 0 0 10  to 0 0 0  fov 20 }
                world { ambience 0  background 0.2 0.2 0.2 }
                material white { diffuse 0.8 0.8 0.8 }
                light key directional { direction 0 0 -1 }
                """);
        for (int i = 0; i < 5; i++) {
            text.append("cylinder stick" + i + " { material white  at " + (0.6 * i - 1.2) + " 0 0  scale 0.03 4 0.03 }\n");
        }
        Scene scene = JenReader.read(text.toString(), "sticks.jen", Path.of("")).scene();
        Scene dimmed = scene.withLight(scene.light("key").orElseThrow().withIntensity(0.5));
        assertThat(match(scene, film(dimmed), MatchSettings.DEFAULT).factors())
                .allSatisfy(f -> assertThat(f.red()).isCloseTo(0.5, within(1e-3)));
    }

    @Test
    void lightNamedEnvironment_isNotTheSky() {
        Scene studio = JenScenes.withSky(StudioScene.withFourLights(40, 32));
        Scene scene = studio.renameLight("fill", "environment");
        Light lamp = scene.light("environment").orElseThrow();
        Scene changed =
                scene.withLight(lamp.withIntensity(2 * lamp.intensity())).withWorld(scene.world().withOwn(own -> own.withIntensity(3)));
        Scene matched = MatchedScene.of(scene, match(scene, film(changed), MatchSettings.DEFAULT));
        assertThat(matched.light("environment").orElseThrow().intensity()).isCloseTo(2 * lamp.intensity(), within(1e-3));
        assertThat(matched.world().own().intensity()).isCloseTo(3, within(1e-3));
    }

    @Test
    void referenceWithoutPixels_isRejected() {
        Scene scene = StudioScene.of(LightType.SPOT);
        ReferenceImage nothing = ReferenceImage.of(film(scene)).within(0.5, 0.5, 0.5, 0.5);
        assertThatThrownBy(() -> match(scene, nothing, MatchSettings.DEFAULT)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("no pixel of the reference counts");
    }

    private static Contribution light(String name) {
        return new SceneElement.OfLight(name);
    }

    private static boolean isAmbiguous(MatchResult result, Contribution light) {
        return result.alike().stream().anyMatch(pair -> pair.first().equals(light) || pair.second().equals(light));
    }

    private static int index(Scene scene, Contribution light) {
        return scene.lights().stream().map(Contribution::of).toList().indexOf(light);
    }

    /** Returns one to eight lights on a sphere around the studio, at least the ninth part of it apart. */
    private static Scene rig(Random random) {
        int count = 1 + random.nextInt(8);
        List<Light> lights = new ArrayList<>();
        for (int l = 0; l < count; l++) {
            double angle = 2 * Math.PI * (l + 0.5 * random.nextDouble()) / count;
            Vec3 at = new Vec3(4 * Math.cos(angle), 1 + 3 * random.nextDouble(), 4 * Math.sin(angle));
            LightType type = random.nextBoolean() ? LightType.POINT : LightType.SPOT;
            lights.add(StudioScene.key(type).withName("light" + l).withPosition(at).withDirection(at.times(-1)).withAngle(40)
                    .withAttenuation(new Attenuation(0.2, 0, 0.05)).withIntensity(Math.exp(3 * random.nextDouble() - 2))
                    .withColor(new Rgb(0.3 + 0.7 * random.nextDouble(), 0.3 + 0.7 * random.nextDouble(), 0.3 + 0.7 * random.nextDouble())));
        }
        Scene scene = StudioScene.of(LightType.SPOT);
        return scene.withPicture(scene.picture().withSize(40, 32)).withLights(lights);
    }

    /** Returns a scene without light that no lamp casts. */
    private static Scene dark(Scene scene) {
        return scene.withWorld(scene.world().withAmbience(0).withBackground(Rgb.BLACK));
    }

    private static Film scaled(Film film, float red, float green, float blue) {
        float[] rgb = film.toScanlines();
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] *= i % 3 == 0 ? red : i % 3 == 1 ? green : blue;
        }
        return Film.ofScanlines(film.width(), film.height(), rgb);
    }

    private static Film film(Scene scene) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return renderer.film();
        }
    }

    private static MatchResult match(Scene scene, Film reference, MatchSettings settings) {
        return match(scene, ReferenceImage.of(reference), settings);
    }

    private static MatchResult match(Scene scene, ReferenceImage reference, MatchSettings settings) {
        try (Renderer renderer = new Renderer(OPTIONS)) {
            renderer.render(scene, Progress.NONE);
            return LightMatch.of(renderer.cache(), OPTIONS, reference, settings, Progress.NONE);
        }
    }
}
