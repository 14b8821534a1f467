package lightning.render.relight.paper;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.LayerStamp;
import lightning.render.image.DisplayCurve;
import lightning.render.relight.FilmError;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the parts of the error bound against hand-computed values, in units u = 2⁻²⁴ and η = 2⁻¹⁵⁰, and when they apply. */
class RatioBoundTest {
    private static final double U = 0x1p-24;
    private static final double ETA = 0x1p-150;

    private static Light light(double r, double g, double b) {
        return Light.of("l", LightType.SPOT).withColor(new Rgb(r, g, b)).withIntensity(2);
    }

    private static final Light ONE = light(0.5, 0.5, 0.5);

    @Test
    void unscaledLayer_losesNothing() {
        ScaledStamp before = new ScaledStamp(ONE, 4, 1e-40, 1e-41);
        assertThat(RatioBound.stampAfterScaling(before, ONE, false, false, 1)).isEqualTo(before);
    }

    /**
     * Weights 1 to 8, 4 and 2: 4η·(1 + 8 + 4)/2 as a share of the smallest channel's weight, plus the initial 2η·(1 + 1) of the
     * weight 1 of the first contributions.
     */
    @Test
    void scaledWeight_addsTwoRoundingsAndWeightLoss() {
        Light target = light(4, 2, 1);
        ScaledStamp after = RatioBound.stampAfterScaling(LayerStamp.ofComputed(ONE), target, true, false, 1);
        assertThat(after).isEqualTo(new ScaledStamp(target, 2, 0, 4 * ETA + 4 * ETA * 13 / 2));
        assertThat(RatioBound.stampAfterScaling(after, target, true, false, 1).weightLoss()).as("adds up")
                .isEqualTo(4 * ETA + 4 * ETA * 13 / 2 + 4 * ETA * 20 / 2);
    }

    /** First weights 8 and 2⁻¹⁰⁰: the loss of 2η·(8 + 1) is 2¹⁰⁰ times that as a share of the dim channel; scaled by 1/2. */
    @Test
    void smallWeight_hasInitialLoss() {
        Light bright = light(4, 0x1p-101, 0);
        double loss = 2 * ETA * 9 * 0x1p100;
        ScaledStamp after = RatioBound.stampAfterScaling(LayerStamp.ofComputed(bright), bright.withIntensity(1), true, false, 1);
        assertThat(after.weightLoss()).isEqualTo(loss + 4 * ETA * 16 * 0x1p101);
    }

    /** Rows that now enter the cone lost more than all earlier scalings; no ray is cast, and falloff and weight are unchanged. */
    @Test
    void layerWithNewRows_hasInitialLoss() {
        ScaledStamp before = new ScaledStamp(ONE, 4, 0x1p-120, 0);
        ScaledStamp after = RatioBound.stampAfterScaling(before, ONE, true, false, 1);
        assertThat(after.weightLoss()).isEqualTo(4 * ETA + 4 * ETA * 6);
        assertThat(after.contributionLoss()).isEqualTo(0x1p-120);
    }

    /** With a falloff down to 2⁻¹⁰, the loss of the weight becomes a share of weight and falloff. */
    @Test
    void scaledFalloff_addsTwoRoundingsAndContributionLoss() {
        ScaledStamp before = new ScaledStamp(ONE, 2, 0x1p-145, 0x1p-146);
        ScaledStamp after = RatioBound.stampAfterScaling(before, ONE, false, true, 0x1p-10);
        assertThat(after).isEqualTo(new ScaledStamp(ONE, 4, 0x1p-145 + (0x1p-146 + 4 * ETA * 6) * 0x1p10, 0));
        assertThat(RatioBound.stampAfterScaling(LayerStamp.ofComputed(ONE), ONE, true, true, 1).roundings()).isEqualTo(4);
    }

    /** A channel below the smallest normal float is never a divisor, so it is not scaled again. */
    @Test
    void subnormalChannel_isIgnored() {
        LayerStamp fresh = LayerStamp.ofComputed(ONE);
        assertThat(RatioBound.stampAfterScaling(fresh, light(1, 0, 1e-40), true, false, 1).weightLoss())
                .isEqualTo(4 * ETA + 4 * ETA * 7 / 2);
        assertThat(RatioBound.stampAfterScaling(fresh, light(1e-40, 0, 0), true, false, 1).weightLoss()).isEqualTo(4 * ETA);
        double min = Float.MIN_NORMAL / 2;
        assertThat(RatioBound.stampAfterScaling(fresh, light(1, 1, min), true, false, 1).weightLoss())
                .isEqualTo(4 * ETA + 4 * ETA * 7 / Float.MIN_NORMAL);
    }

    /** 6 roundings of the two contributions, 4 of two scalings, and twice: the levels of the sum over the films, 8 for the equation, 5 per mirror. */
    @ParameterizedTest
    @CsvSource({"1,0,2", "2,0,3", "3,0,3", "4,0,4", "5,0,4", "8,1,5", "9,10,5"})
    void relativePart_countsRoundingsToFilm(int lights, int mirrors, int sumDepth) {
        LayerStamp[] stamps = new LayerStamp[lights];
        stamps[0] = new ScaledStamp(ONE, 4, 0, 0);
        if (lights > 2) {
            stamps[2] = new ScaledStamp(ONE, 2, 0, 0);
        }
        double n = 6 + 4 + 2 * (sumDepth + 8 + 5 * mirrors);
        assertThat(RatioBound.relative(stamps, mirrors, 1)).isCloseTo(n * U / (1 - 2 * n * U), withinPercentage(1e-9));
    }

    /** The mean of 16 samples has four levels of additions, a division, and a sum with further samples; four films have two levels. */
    @Test
    void sampleMean_addsRoundingsOfBothImages() {
        LayerStamp[] stamps = {new ScaledStamp(ONE, 2, 0, 0)};
        double n = 6 + 2 + 2 * (2 + 8 + 4 + 2);
        assertThat(RatioBound.relative(stamps, 0, 16)).isCloseTo(n * U / (1 - 2 * n * U), withinPercentage(1e-9));
    }

    /** Stored contributions contain weights, and films do not. */
    @Test
    void unscaledLayers_differByRoundings() {
        LayerStamp[] fresh = {LayerStamp.ofComputed(ONE), null};
        double n = 6 + 2 * (3 + 8 + 5 * 3);
        assertThat(RatioBound.relative(fresh, 3, 1)).isCloseTo(n * U / (1 - 2 * n * U), withinPercentage(1e-9));
        assertThat(RatioBound.absolute(fresh, 4, 2)).isCloseTo(4 * 2 * (4 * ETA + 16 * ETA + 2 * Float.MIN_NORMAL), withinPercentage(1e-9));
        assertThat(RatioBound.absolute(new LayerStamp[0], 4, 2)).isZero();
    }

    /** Twice the loss of each light, 16 operations on its film, and two smallest normal floats, on 3 levels. */
    @Test
    void absolutePart_isTwiceLossOfLights() {
        Light four = light(2, 1, 0);
        LayerStamp[] stamps =
                {new ScaledStamp(ONE, 2, 0x1p-100, 0x1p-101), null, LayerStamp.ofComputed(ONE), new ScaledStamp(four, 4, 0x1p-100, 0)};
        double loss =
                0x1p-100 + 0x1p-101 + 16 * ETA + 4 * ETA + 16 * ETA + 4 * 0x1p-100 + 2 * 5 * ETA + 4 * 16 * ETA + 6 * Float.MIN_NORMAL;
        assertThat(RatioBound.absolute(stamps, 3, 2)).isCloseTo(3 * 2 * loss, withinPercentage(1e-9));
    }

    /** The largest slope of sRGB is 1.055/2.4 for a relative change and 12.92 for a difference. */
    @Test
    void bound_isVisibleFromHalfEightBitStep() {
        double relative = 0.5 / 255 / (1.055 / 2.4);
        assertThat(new ErrorBound(relative * 0.9999, 0).isVisible(0, DisplayCurve.SRGB)).isFalse();
        assertThat(new ErrorBound(relative * 1.0001, 0).isVisible(0, DisplayCurve.SRGB)).isTrue();
        double absolute = 0.5 / 255 / 12.92;
        for (double exposure : new double[] {-3, 0, 7}) {
            double shown = absolute * Math.pow(2, -exposure);
            assertThat(new ErrorBound(0, shown * 0.9999).isVisible(exposure, DisplayCurve.SRGB)).isFalse();
            assertThat(new ErrorBound(0, shown * 1.0001).isVisible(exposure, DisplayCurve.SRGB)).isTrue();
            assertThat(new ErrorBound(relative / 2, shown * 0.499).isVisible(exposure, DisplayCurve.SRGB)).isFalse();
            assertThat(new ErrorBound(relative / 2, shown * 0.501).isVisible(exposure, DisplayCurve.SRGB)).isTrue();
        }
    }

    private static Renderer renderer() {
        return new Renderer(new RenderOptions(Accuracy.RATIO, ReflectionMode.CURRENT, MirrorStorage.FULL_ROWS, 1));
    }

    /** The relative part of the brightest value, plus the absolute part of the first level and of two mirrored ones. */
    @Test
    void reportedBound_isForBrightestValue() {
        Scene scene = StudioScene.of(LightType.SPOT);
        Light key = scene.lights().getFirst();
        Light dim = key.withIntensity(0.5);
        try (Renderer renderer = renderer()) {
            assertThat(renderer.render(scene, Progress.NONE).errorBound()).isBetween(1e-9, 1e-4);
            UpdateResult update = renderer.render(scene.withLight(dim), Progress.NONE);
            double brightest = 0;
            for (float value : renderer.film().toScanlines()) {
                brightest = Math.max(brightest, value);
            }
            LayerStamp[] stamps = {RatioBound.stampAfterScaling(LayerStamp.ofComputed(key), dim, true, false, 1)};
            assertThat(update.errorBound()).isCloseTo(RatioBound.relative(stamps, 2, 1) * brightest + RatioBound.absolute(stamps, 3, 2),
                    within(1e-20));
            assertThat(brightest).isGreaterThan(0.1);
        }
    }

    /** Renders each of the lights in the key light's place over a black world and compares the last picture. */
    private static void assertWithinBound(List<Light> lights, double minError) {
        Scene scene = StudioScene.of(LightType.SPOT).withWorld(new World(0, Rgb.BLACK));
        try (Renderer renderer = renderer()) {
            UpdateResult update = null;
            for (Light light : lights) {
                update = renderer.render(scene.withLight(light), Progress.NONE);
            }
            double error = FilmError.largestError(renderer.film(), new ReferenceTracer(scene.withLight(lights.getLast())).trace());
            assertThat(error).isGreaterThanOrEqualTo(minError);
            assertThat(update.errorBound()).isGreaterThanOrEqualTo(error);
        }
    }

    /** The ratio of the weights is 0: the value 10⁻³⁹ is lost, and the bound includes it. */
    @Test
    void subnormalWeight_canBeLost() {
        Light key = StudioScene.key(LightType.SPOT).withDropoff(0).withAttenuation(Attenuation.NONE);
        assertWithinBound(List.of(key.withIntensity(1e10), key.withIntensity(1e-39)), 1e-40);
    }

    /**
     * Contributions of the smallest float, scaled by 0.6, round to the same value repeatedly. After many steps down, the one step
     * up turned 10⁻⁴⁰ into 10⁻¹⁵, and the bound did not include it.
     */
    @Test
    void subnormalWeight_isNotScaledByFalloff() {
        Light key = StudioScene.key(LightType.SPOT).withDropoff(0);
        List<Light> lights = new ArrayList<>(List.of(key));
        for (Rgb color : List.of(Rgb.gray(1e-40), new Rgb(1, 1e-40, 1), new Rgb(1e-37, 1e-40, 0))) {
            Light dim = key.withColor(color);
            for (double constant = 1; constant < 1e30; constant /= 0.6) {
                lights.add(dim.withAttenuation(new Attenuation(constant, 0, 0)));
            }
            lights.add(dim.withColor(new Rgb(0, 1e-40, 0)));
            lights.add(dim.withColor(new Rgb(0, 1e-40, 0)).withAttenuation(Attenuation.NONE));
            assertWithinBound(lights, 0);
        }
    }

    /** A bound at that exposure is visible immediately: contributions are recomputed, and the bound returns to a few roundings. */
    @Test
    void visibleError_triggersRefresh() {
        Scene scene = StudioScene.of(LightType.SPOT).withWorld(new World(0, Rgb.BLACK));
        Light key = scene.lights().getFirst();
        try (Renderer renderer = renderer()) {
            renderer.render(scene, Progress.NONE);
            Scene narrow = scene.withLight(key.withDropoff(900));
            assertThat(renderer.render(narrow, Progress.NONE).wasRefreshed()).isFalse();
            renderer.setView(64, DisplayCurve.SRGB);
            Scene back = narrow.withLight(key.withDropoff(1));
            UpdateResult update = renderer.render(back, Progress.NONE);
            assertThat(update.wasRefreshed()).isTrue();
            assertThat(update.errorBound()).isLessThan(1e-4);
            assertThat(update.rays().shadow()).isZero();
            assertThat(FilmError.largestError(renderer.film(), new ReferenceTracer(back).trace())).isLessThanOrEqualTo(update.errorBound());
        }
    }
}
