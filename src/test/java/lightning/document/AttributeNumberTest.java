package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.NumberUnit;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.SceneNode;
import lightning.scene.value.Attenuation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

class AttributeNumberTest {
    private final Scene scene = DeskScene.scene();

    /** Checks that exactly the documented degree parameters are entered and shown in degrees. */
    @Test
    void degreeParameters_matchDocumentation() {
        Stream<SceneAttribute<?, ?>> all = Stream.<List<? extends SceneAttribute<?, ?>>>of(LightAttribute.ALL, MaterialAttribute.ALL,
                World.ATTRIBUTES, Camera.ATTRIBUTES, SceneNode.ATTRIBUTES).flatMap(List::stream);
        assertThat(all.filter(a -> a.kind() instanceof NumericKind<?>))
                .allSatisfy(a -> assertThat(((NumericKind<?>) a.kind()).unit())
                        .isEqualTo(a.unit().contains("degrees") ? NumberUnit.DEGREES
                                : a.unit().equals("stops") ? NumberUnit.STOPS : a.unit().equals("kelvin") ? NumberUnit.KELVIN
                                : NumberUnit.FACTOR));
    }

    private static double step(double value, String number, int steps) {
        return DeskScene.parameter(number).range().addSteps(value, steps);
    }

    @Test
    void step_addsTenthInDecimal() {
        assertThat(step(1.1, "intensity", 1)).isEqualTo(1.2);
        assertThat(step(1.1, "intensity", -4)).isEqualTo(0.7);
    }

    @Test
    void step_changesAnglesByOneDegree() {
        assertThat(step(25, "angle", 2)).isEqualTo(27);
    }

    @Test
    void step_stopsAtLimits() {
        assertThat(step(1, "intensity", -20)).isZero();
        assertThat(AttributeNumber.DEPTH.range().addSteps(2, 100)).isEqualTo(10);
    }

    @Test
    void value_isSet() {
        assertThat(DeskScene.light(DeskScene.sceneOf(DeskScene.parameter("intensity").set(scene, "key", 0.4)), "key").intensity())
                .isEqualTo(0.4);
    }

    @Test
    void negativeValue_isRefusedWithReason() {
        assertThat(DeskScene.parameter("intensity").set(scene, "key", -3).refusal()).contains("intensity must be ≥ 0, was -3");
    }

    @Test
    void fractionalDepth_isRefused() {
        assertThat(AttributeNumber.DEPTH.set(scene, "", 2.5).refusal()).contains("reflection bounces must be a whole number, was 2.5");
    }

    @Test
    void refusal_changesNothing() {
        assertThat(DeskScene.parameter("angle").set(scene, "key", 181).sceneOr(scene)).isSameAs(scene);
    }

    @Test
    void unknownLight_isRefused() {
        assertThat(DeskScene.parameter("intensity").set(scene, "missing", 1).refusal()).contains("light 'missing' not found");
    }

    @Test
    void attenuationParameters_setTheirOwnConstant() {
        Scene edited =
                DeskScene
                        .sceneOf(
                                DeskScene.parameter("attenuation quadratic")
                                        .set(DeskScene.sceneOf(DeskScene.parameter("attenuation linear").set(DeskScene.sceneOf(
                                                DeskScene.parameter("attenuation constant").set(scene, "fill", 2)), "fill", 3)), "fill",
                                                4));
        assertThat(DeskScene.light(edited, "fill").attenuation()).isEqualTo(new Attenuation(2, 3, 4));
    }

    @Test
    void spot_hasEveryParameterExceptOtherAreas() {
        assertThat(AttributeNumber.ALL.stream().filter(number -> number.inactiveReason(scene, "key").isPresent())
                .map(AttributeNumber::title).toList())
                .containsExactlyInAnyOrder("cone cutoff", "cone softness", "beam spread", "spread", "width", "height",
                        "environment intensity", "environment light gain", "environment tilt", "environment roll",
                        "environment rotation",
                        "environment bright lights",
                        "environment shadow smoothing", "fog anisotropy", "fog height", "fog falloff with height", "fog size x",
                        "fog size y", "fog size z", "red", "green", "blue", "red", "green", "blue", "red", "green", "blue",
                        "flag rotation x", "flag rotation y", "flag rotation z", "flag width",
                        "flag height", "flag softness", "flag density", "filter rotation x", "filter rotation y", "filter rotation z",
                        "filter size x", "filter size y", "filter size z", "filter softness", "filter density", "sun elevation",
                        "sun azimuth", "sky turbidity", "sun strength", "sun radius");
    }

    @Test
    void pointLight_hasNoConeAndNoDirection() {
        assertThat(DeskScene.parameter("angle").inactiveReason(scene, "fill"))
                .contains("a point light has no cone half-angle");
        assertThat(DeskScene.parameter("dropoff").inactiveReason(scene, "fill"))
                .contains("a point light has no edge falloff");
        assertThat(DeskScene.parameter("attenuation linear").inactiveReason(scene, "fill")).isEmpty();
        assertThat(LightAttribute.DIRECTION.inactiveReason(LightType.POINT)).contains("a point light has no direction");
    }

    @Test
    void directionalLight_hasColorIntensityDirectionSpreadLinksAndGainsOnly() {
        assertThat(LightAttribute.ALL.stream().filter(a -> a.term(LightType.DIRECTIONAL).isPresent()).toList())
                .isEqualTo(List.of(LightAttribute.COLOR, LightAttribute.INTENSITY, LightAttribute.EXPOSURE, LightAttribute.UNIT,
                        LightAttribute.TEMPERATURE, LightAttribute.DIRECTION, LightAttribute.SPREAD,
                        LightAttribute.SAMPLES, LightAttribute.ILLUMINATES, LightAttribute.SHADOWED_BY,
                        LightAttribute.CASTS_SHADOWS, LightAttribute.DIFFUSE, LightAttribute.SPECULAR, LightAttribute.FOG,
                        LightAttribute.GAINS, LightAttribute.FLAG, LightAttribute.FLAG_POSITION, LightAttribute.FLAG_ROTATION,
                        LightAttribute.FLAG_WIDTH, LightAttribute.FLAG_HEIGHT, LightAttribute.FLAG_SOFTNESS, LightAttribute.FLAG_DENSITY,
                        LightAttribute.FILTER, LightAttribute.FILTER_POSITION, LightAttribute.FILTER_ROTATION, LightAttribute.FILTER_SIZE,
                        LightAttribute.FILTER_SOFTNESS, LightAttribute.FILTER_DENSITY, LightAttribute.FILTER_INVERTED));
        assertThat(DeskScene.parameter("attenuation constant").inactiveReason(scene, "sun"))
                .contains("a directional light has no attenuation");
    }

    @ParameterizedTest
    @FieldSource("lightning.document.AttributeNumber#ALL")
    void setValue_changesOnlyThatValue(AttributeNumber<?, ?> dial) {
        double other = Math.clamp(dial.value(scene, "key") == 5 ? 6 : 5, dial.range().min(), dial.range().max());
        Scene edited = DeskScene.sceneOf(dial.set(scene, "key", other));
        assertThat(dial.value(edited, "key")).isEqualTo(other);
        assertThat(DeskScene.sceneOf(dial.set(edited, "key", dial.value(scene, "key")))).isEqualTo(scene);
    }

    @Property
    void stepsUpAndDown_restoreValue(@ForAll @IntRange(max = 100) int steps, @ForAll @DoubleRange(max = 9) double value) {
        double rounded = Math.rint(value * 100) / 100;
        assertThat(step(step(rounded, "dropoff", steps), "dropoff", -steps)).isEqualTo(rounded);
    }
}
