package lightning.scene.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.EnumSet;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Exposure, photometric units and temperature of lights. Luminance of white paper is illuminance over π. */
class EmissionTest {
    private static double paper(Light light, double meters, double distance) {
        Light effective = Emission.resolve(light, meters);
        double meanCosine = light.type().hasPosition() ? 1 : (1 + Math.cos(Math.toRadians(light.area().spread()))) / 2;
        return effective.weight().max() * meanCosine / (light.type().hasPosition() ? distance * distance : 1);
    }

    private static Light light(LightType type, IntensityUnit unit, double intensity) {
        return Light.of("l", type).withIntensity(intensity).withFalloff(Falloff.INVERSE_SQUARE)
                .withEmission(Emission.DEFAULT.withUnit(unit));
    }

    @Test
    void candela_isLuxAtOneMeter() {
        // 100 cd at 2 m give 25 lx, in scenes of meters and of centimeters.
        assertThat(paper(light(LightType.POINT, IntensityUnit.CANDELA, 100), 1, 2)).isCloseTo(25 / Math.PI, within(1e-12));
        assertThat(paper(light(LightType.SPOT, IntensityUnit.CANDELA, 100), 0.01, 200)).isCloseTo(25 / Math.PI, within(1e-12));
        assertThat(paper(light(LightType.RECT, IntensityUnit.LUX, 25), 1, 1)).isCloseTo(25 / Math.PI, within(1e-12));
        assertThat(paper(light(LightType.DIRECTIONAL, IntensityUnit.LUX, 100_000), 0.01, 1)).isCloseTo(100_000 / Math.PI, within(1e-6));
    }

    @Test
    void lumens_areSpreadOverTheWholeLight() {
        double atOneMeter = 1 / Math.PI;
        assertThat(paper(light(LightType.POINT, IntensityUnit.LUMEN, 4 * Math.PI), 1, 1)).isCloseTo(atOneMeter, within(1e-12));
        assertThat(paper(light(LightType.DISC, IntensityUnit.LUMEN, Math.PI), 1, 1)).isCloseTo(atOneMeter, within(1e-12));
        Light halfSpace = light(LightType.SPOT, IntensityUnit.LUMEN, 2 * Math.PI).withAngle(90);
        assertThat(paper(halfSpace, 1, 1)).isCloseTo(atOneMeter, within(1e-12));
        // A cosine halves the flux of a half space.
        assertThat(paper(halfSpace.withDropoff(1), 1, 1)).isCloseTo(2 * atOneMeter, within(1e-12));
    }

    @Test
    void nits_areLuminanceTimesArea() {
        Light panel = light(LightType.RECT, IntensityUnit.NIT, 1000).withArea(AreaShape.DEFAULT.withWidth(2).withHeight(3));
        // 6000 cd at 10 m, where the panel is small.
        assertThat(paper(panel, 1, 10)).isCloseTo(60 / Math.PI, within(1e-9));
        Light sky = light(LightType.DIRECTIONAL, IntensityUnit.NIT, 7).withArea(AreaShape.DEFAULT.withSpread(90));
        assertThat(paper(sky, 1, 1)).as("paper is as bright as a uniform sky").isCloseTo(7, within(1e-12));
        assertThat(paper(light(LightType.POINT, IntensityUnit.NIT, 7), 1, 1)).as("without size").isZero();
    }

    @ParameterizedTest
    @EnumSource(value = IntensityUnit.class, names = {"RELATIVE", "CANDELA", "LUMEN", "LUX"})
    void width_keepsTheBrightnessOfADirectionalLight(IntensityUnit unit) {
        Light sun = light(LightType.DIRECTIONAL, unit, 100);
        for (double spread : new double[] {0.5, 10, 30, 60, 85, 90}) {
            assertThat(paper(sun.withArea(AreaShape.DEFAULT.withSpread(spread)), 1, 1)).isCloseTo(paper(sun, 1, 1), within(1e-10));
        }
    }

    @Test
    void hardShadows_keepTheWeight() {
        AreaShape wide = AreaShape.DEFAULT.withSpread(60);
        Light sun = light(LightType.DIRECTIONAL, IntensityUnit.LUX, 100);
        assertThat(sun.withArea(wide.withHardShadows(true)).weight()).isEqualTo(sun.weight());
        assertThat(sun.withArea(wide).diffuseWeight().r()).isEqualTo(100 * 4 / 3.0, within(1e-12));
        assertThat(sun.withArea(wide).specularWeight()).isEqualTo(sun.withArea(wide).diffuseWeight());
    }

    @Test
    void exposure_doublesTheLight() {
        Light light = light(LightType.POINT, IntensityUnit.RELATIVE, 3);
        assertThat(paper(light.withEmission(light.emission().withExposure(4)), 1, 1)).isEqualTo(48);
        assertThat(paper(light.withEmission(light.emission().withExposure(-1)), 1, 1)).isEqualTo(1.5);
    }

    @Test
    void temperature_multipliesTheColorAndKeepsTheLuminance() {
        Light light = light(LightType.POINT, IntensityUnit.RELATIVE, 2);
        Rgb warm = Emission.resolve(light.withEmission(light.emission().withTemperature(2700)), 1).weight();
        assertThat(0.2126 * warm.r() + 0.7152 * warm.g() + 0.0722 * warm.b()).isCloseTo(2, within(1e-12));
        assertThat(warm.r()).isGreaterThan(warm.g());
        assertThat(warm.g()).isGreaterThan(warm.b());
    }

    @ParameterizedTest
    @EnumSource
    void unitChange_keepsTheLight(IntensityUnit unit) {
        // The surface of an object belongs to a scene: ObjectLightTest.
        for (LightType type : EnumSet.complementOf(EnumSet.of(LightType.OBJECT))) {
            Light light = light(type, IntensityUnit.RELATIVE, 3).withArea(new AreaShape(0.3, 20, 1, 2, Vec3.Y, 16));
            assertThat(paper(Emission.withUnit(light, unit, 0.02), 0.02, 1)).isCloseTo(3, within(1e-9));
        }
    }

    /** No exposure, unit or group may exceed the limits by which no product overflows. */
    @Test
    void extremeLights_areLimited() {
        Light light = light(LightType.POINT, IntensityUnit.LUMEN, SceneLimits.MAX_INTENSITY).withLightGroup("g");
        Light bright = light.withEmission(light.emission().withExposure(Emission.MAX_EXPOSURE).withTemperature(1667));
        LightRig rig = LightRig.of(List.of(bright), List.of(LightGroup.of("g").withIntensity(1000)))
                .withEnvironments(List.of(), SceneLimits.MIN_METERS);
        assertThat(rig.effectiveLight(bright).weight().max() * bright.maxFalloff()).isLessThanOrEqualTo(1.000001e30);
    }

    @Test
    void neutralLight_isItself() {
        Light plain = Light.of("l", LightType.SPOT);
        assertThat(LightRig.of(List.of(plain)).effectiveLights().getFirst()).isSameAs(plain);
    }
}
