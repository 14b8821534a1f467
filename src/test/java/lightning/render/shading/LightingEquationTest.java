package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the terms of the equation at a row in the origin with normal y. */
class LightingEquationTest {
    private static final double FLOAT = 1e-7;

    private static LightingEquation equationAt(Light light) {
        Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
        Scene scene = new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(light));
        LightingEquation equation = new LightingEquation(LightSource.of(light, scene));
        equation.moveTo(0, 0, 0, 0, 1, 0);
        return equation;
    }

    private static Light point(double x, double y, double z) {
        return Light.of("l", LightType.POINT).withPosition(new Vec3(x, y, z));
    }

    private static Light spot(double degreesOffAxis) {
        double angle = Math.toRadians(degreesOffAxis);
        return Light.of("l", LightType.SPOT).withPosition(new Vec3(0, 2, 0))
                .withDirection(new Vec3(Math.sin(angle), -Math.cos(angle), 0)).withAngle(180);
    }

    @ParameterizedTest
    @CsvSource({"0,1", "30,0.8660254", "45,0.7071068", "60,0.5", "90,0", "120,-0.5"})
    void cosine_matchesAngleToNormal(double degrees, double cosine) {
        double angle = Math.toRadians(degrees);
        Vec3 up = new Vec3(Math.sin(angle), Math.cos(angle), 0);
        assertThat((double) equationAt(point(3 * up.x(), 3 * up.y(), 0)).cosine(0, 1, 0)).isCloseTo(cosine, within(FLOAT));
        Light directional = Light.of("l", LightType.DIRECTIONAL).withDirection(up.times(-5));
        assertThat((double) equationAt(directional).cosine(0, 1, 0)).isCloseTo(cosine, within(FLOAT));
    }

    @Test
    void lightAtRow_isTreatedAsOverhead() {
        LightingEquation equation = equationAt(point(0, 0, 0));
        assertThat(equation.cosine(0, 1, 0)).isEqualTo(1);
        assertThat(equation.falloff()).isEqualTo(1);
    }

    /** The ray comes down at 45°; the light is in the mirror direction, then 60° from it. */
    @ParameterizedTest
    @CsvSource({"45,1,1", "45,20,1", "-15,1,0.5", "-15,2,0.25", "-15,0.5,0.7071068", "-15,0,1", "-60,3,0"})
    void specular_isPowerOfMirrorCosine(double degrees, double shininess, double specular) {
        double angle = Math.toRadians(degrees);
        float v = (float) Math.sqrt(0.5);
        LightingEquation equation = equationAt(point(Math.sin(angle), Math.cos(angle), 0));
        assertThat((double) equation.specular(0, 1, 0, v, -v, 0, shininess)).isCloseTo(specular, within(3 * FLOAT));
    }

    @ParameterizedTest
    @CsvSource({"1,0,0,1", "2,0,0,0.5", "0,1,0,0.5", "0,0,1,0.25", "1,1,1,0.14285714", "0.5,0,0,1", "0,0,0,1", "-0.0,-0.0,-0.0,1",
        "0,0.25,0,1"})
    void attenuation_isReciprocalClampedToOne(double constant, double linear, double quadratic, double factor) {
        Light light = point(0, 2, 0).withAttenuation(new Attenuation(constant, linear, quadratic));
        assertThat((double) equationAt(light).falloff()).isCloseTo(factor, within(FLOAT));
        assertThat((double) equationAt(spot(0).withAttenuation(light.attenuation())).falloff()).isCloseTo(factor, within(FLOAT));
    }

    @Test
    void attenuationAtZeroDistance_isOne() {
        assertThat(equationAt(point(0, 0, 0).withAttenuation(new Attenuation(0, 1, 1))).falloff()).isEqualTo(1);
    }

    @Test
    void directionalLight_hasNoFalloff() {
        Light light = Light.of("l", LightType.DIRECTIONAL).withAttenuation(new Attenuation(9, 9, 9)).withDropoff(9);
        assertThat(equationAt(light).falloff()).isEqualTo(1);
    }

    @Test
    void pointLight_hasNoSpotCoefficient() {
        assertThat(equationAt(point(0, 2, 0).withDropoff(9).withDirection(new Vec3(1, 0, 0))).falloff()).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource({"0,5,1", "60,1,0.5", "60,2,0.25", "60,0.5,0.7071068", "60,0,1", "120,1,0", "120,3,0"})
    void spotCoefficient_isPowerOfAxisCosine(double degrees, double dropoff, double spot) {
        assertThat((double) equationAt(spot(degrees).withDropoff(dropoff)).falloff()).isCloseTo(spot, within(FLOAT));
    }

    @Test
    void spotWithoutDropoff_hasFullIntensityBehind() {
        assertThat(equationAt(spot(120).withDropoff(0)).falloff()).as("0^0 = 1").isEqualTo(1);
    }

    @Test
    void rowOnConeBoundary_isInside() {
        assertThat(equationAt(spot(0).withAngle(0)).insideCone()).as("on the axis of an empty cone").isTrue();
        Light sideways = spot(0).withDirection(new Vec3(1, 0, 0)).withAngle(90);
        assertThat(equationAt(sideways).insideCone()).as("at a right angle").isTrue();
        Light away = spot(0).withDirection(new Vec3(0, 1, 0)).withAngle(180);
        assertThat(equationAt(away).insideCone()).as("opposite to a cone of 180°").isTrue();
    }

    /** Rounding makes the cosine less than −1, the cosine of 180°, for some of these. */
    @Test
    void rowBehindLight_isInsideConeOf180Degrees() {
        Random random = new Random(1);
        for (int n = 0; n < 1000; n++) {
            Vec3 away = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            Light light = spot(0).withPosition(away).withDirection(away).withAngle(180);
            assertThat(equationAt(light).insideCone()).as("%s", away).isTrue();
        }
    }

    @ParameterizedTest
    @CsvSource({"30,29.999,false", "30,30.001,true", "0.001,0,false", "179,178.9,false", "90,89.9999,false"})
    void cone_containsRowsUpToHalfAngle(double degrees, double angle, boolean inside) {
        assertThat(equationAt(spot(degrees).withAngle(angle)).insideCone()).isEqualTo(inside);
    }

    @Test
    void onlySpotLights_haveCone() {
        assertThat(equationAt(point(0, 2, 0).withAngle(0).withDirection(new Vec3(1, 0, 0))).insideCone()).isTrue();
    }

    @Test
    void contribution_multipliesTermAndFalloffFirst() {
        assertThat(LightingEquation.contribution(2, 0.5f, 0.25f, 1)).isEqualTo(0.25f);
        float weight = 3e38f;
        assertThat(LightingEquation.contribution(weight, 0.5f, 1e-38f, 1)).isEqualTo(weight * (0.5f * 1e-38f));
    }

    /** ((1 + t) + (t + t)) with t half of the last place of 1: from left to right every t would be lost. */
    @Test
    void sum_isBalancedTree() {
        float t = 0x1p-24f;
        assertThat(LightingEquation.sum(new float[] {1, t, t, t}, 0, 4)).isEqualTo(1 + 0x1p-23f);
        assertThat(LightingEquation.sum(new float[] {t, t, 1}, 0, 3)).isEqualTo(1 + 0f);
        assertThat(LightingEquation.sum(new float[] {1, t, t}, 0, 3)).isEqualTo(1 + 0x1p-23f);
        assertThat(LightingEquation.sum(new float[0], 0, 0)).isZero();
    }

    @Test
    void weight_isColorTimesIntensityOfEnabledLight() {
        Light light = point(0, 2, 0).withColor(new Rgb(1, 0.5, 0.25)).withIntensity(2);
        Light other = point(0, 3, 0).withName("solo").withSolo(true);
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of(light));
        WeightedLight shining = WeightedLight.of(light, scene);
        assertThat(List.of(shining.diffuse().red(), shining.diffuse().green(), shining.diffuse().blue())).containsExactly(2f, 1f, 0.5f);
        assertThat(WeightedLight.of(light.withOn(false), scene.withLight(light.withOn(false))).isDark()).isTrue();
        assertThat(WeightedLight.of(light, scene.withLights(List.of(light, other))).isDark()).isTrue();
        assertThat(WeightedLight.of(light, scene.withLights(List.of(light, other.withOn(false)))).isDark()).isFalse();
    }
}
