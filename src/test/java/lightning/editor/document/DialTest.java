package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.text.Measure;
import lightning.scene.Attenuation;
import lightning.scene.Attribute;
import lightning.scene.Camera;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.MaterialAttribute;
import lightning.scene.Node;
import lightning.scene.Quantity;
import lightning.scene.Scene;
import lightning.scene.World;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

class DialTest {
    private final Scene scene = Desk.scene();

    /** What the documents call degrees is typed and shown in degrees, and nothing else is. */
    @Test
    void numbersInDegrees_areThoseThatTheDocumentsCallSo() {
        Stream<Attribute<?, ?>> all = Stream.<List<? extends Attribute<?, ?>>>of(LightAttribute.ALL, MaterialAttribute.ALL,
                World.ATTRIBUTES, Camera.ATTRIBUTES, Node.ATTRIBUTES).flatMap(List::stream);
        assertThat(all.filter(a -> a.kind() instanceof Quantity<?>))
                .allSatisfy(a -> assertThat(((Quantity<?>) a.kind()).measure())
                        .isEqualTo(a.unit().contains("degrees") ? Measure.DEGREES : Measure.FACTOR));
        assertThat(Dial.of(LightAttribute.DOORS)).hasSize(4).allMatch(d -> d.measure() == Measure.DEGREES);
        assertThat(Dial.ENVIRONMENT_ROTATION.measure()).isEqualTo(Measure.DEGREES);
        assertThat(Dial.AMBIENCE.measure()).isEqualTo(Measure.FACTOR);
    }

    @Test
    void click_addsATenthInDecimal() {
        Scene once = Desk.done(Desk.dial("intensity").set(scene, "key", 1.1));
        assertThat(Desk.light(Desk.done(Desk.dial("intensity").stepped(once, "key", 1)), "key").intensity()).isEqualTo(1.2);
        assertThat(Desk.light(Desk.done(Desk.dial("intensity").stepped(once, "key", -4)), "key").intensity()).isEqualTo(0.7);
    }

    @Test
    void click_turnsAnglesByADegree() {
        assertThat(Desk.light(Desk.done(Desk.dial("angle").stepped(scene, "key", 2)), "key").angle()).isEqualTo(27);
    }

    @Test
    void click_stopsAtTheLimits() {
        assertThat(Desk.done(Desk.dial("intensity").stepped(scene, "fill", -20)).light("fill").orElseThrow().intensity()).isZero();
        assertThat(Desk.done(Dial.DEPTH.stepped(scene, "", 100)).picture().depth()).isEqualTo(10);
    }

    @Test
    void value_isTaken() {
        assertThat(Desk.light(Desk.done(Desk.dial("intensity").set(scene, "key", 0.4)), "key").intensity()).isEqualTo(0.4);
    }

    @Test
    void valueBelowZero_isRefusedWithTheReason() {
        assertThat(Desk.dial("intensity").set(scene, "key", -3).refusal()).contains("intensity must be ≥ 0, was -3");
    }

    @Test
    void fractionOfABounce_isRefused() {
        assertThat(Dial.DEPTH.set(scene, "", 2.5).refusal()).contains("depth must be a whole number, was 2.5");
    }

    @Test
    void refusal_changesNothing() {
        assertThat(Desk.dial("angle").set(scene, "key", 181).or(scene)).isSameAs(scene);
    }

    @Test
    void unknownLight_isRefused() {
        assertThat(Desk.dial("intensity").set(scene, "nobody", 1).refusal()).contains("there is no light 'nobody'");
        assertThat(Desk.dial("intensity").stepped(scene, "nobody", 1).refusal()).contains("there is no light 'nobody'");
    }

    @Test
    void attenuationDials_setTheirOwnConstant() {
        Scene edited = Desk.done(Desk.dial("attenuation quadratic").set(Desk.done(Desk.dial("attenuation linear").set(Desk.done(
                Desk.dial("attenuation constant").set(scene, "fill", 2)), "fill", 3)), "fill", 4));
        assertThat(Desk.light(edited, "fill").attenuation()).isEqualTo(new Attenuation(2, 3, 4));
    }

    @Test
    void spot_hasEveryDialButThoseOfOtherAreas() {
        assertThat(Dial.ALL.stream().filter(dial -> dial.obstacle(scene, scene.light("key")).isPresent()).map(Dial::title).toList())
                .containsExactlyInAnyOrder("spread", "width", "height", "environment intensity", "environment rotation",
                        "environment lamps",
                        "environment softness");
    }

    @Test
    void pointLight_hasNoConeAndNoDirection() {
        assertThat(Desk.dial("angle").obstacle(scene, scene.light("fill"))).contains("a point light has no angle");
        assertThat(Desk.dial("dropoff").obstacle(scene, scene.light("fill"))).contains("a point light has no dropoff");
        assertThat(Desk.dial("attenuation linear").obstacle(scene, scene.light("fill"))).isEmpty();
        assertThat(LightAttribute.DIRECTION.obstacle(LightType.POINT)).contains("a point light has no direction");
    }

    @Test
    void directionalLight_hasColorIntensityDirectionSpreadAndLinksOnly() {
        assertThat(LightAttribute.ALL.stream().filter(a -> a.term(LightType.DIRECTIONAL).isPresent()).toList())
                .isEqualTo(List.of(LightAttribute.COLOR, LightAttribute.INTENSITY, LightAttribute.DIRECTION, LightAttribute.SPREAD,
                        LightAttribute.SAMPLES, LightAttribute.ILLUMINATES, LightAttribute.SHADOWED_BY));
        assertThat(Desk.dial("attenuation constant").obstacle(scene, scene.light("sun")))
                .contains("a directional light has no attenuation");
    }

    @Test
    void withoutASelection_onlyTheScenesDialsTurn() {
        for (Dial dial : Dial.ALL) {
            assertThat(dial.obstacle(scene, Optional.empty()).isEmpty()).isEqualTo(dial == Dial.AMBIENCE || dial == Dial.DEPTH);
        }
    }

    @ParameterizedTest
    @FieldSource("lightning.editor.document.Dial#ALL")
    void setValue_isTheValueShownAndNothingElseChanges(Dial dial) {
        double other = Math.min(dial.value(scene, "key") == 5 ? 6 : 5, dial.steps().max());
        Scene edited = Desk.done(dial.set(scene, "key", other));
        assertThat(dial.value(edited, "key")).isEqualTo(other);
        assertThat(Desk.done(dial.set(edited, "key", dial.value(scene, "key")))).isEqualTo(scene);
    }

    @Property
    void stepsUpAndDown_comeBack(@ForAll @IntRange(max = 100) int steps, @ForAll @DoubleRange(max = 9) double value) {
        double rounded = Math.rint(value * 100) / 100;
        Scene begin = Desk.done(Desk.dial("dropoff").set(scene, "key", rounded));
        Scene up = Desk.done(Desk.dial("dropoff").stepped(begin, "key", steps));
        assertThat(Desk.done(Desk.dial("dropoff").stepped(up, "key", -steps))).isEqualTo(begin);
    }
}
