package lightning.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Optional;
import lightning.scene.Attenuation;
import lightning.scene.LightType;
import lightning.scene.Scene;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class DialTest {
    private final Scene scene = Desk.scene();

    @Test
    void click_addsATenthInDecimal() {
        Scene once = Desk.done(Dial.INTENSITY.set(scene, "key", 1.1));
        assertThat(Desk.light(Desk.done(Dial.INTENSITY.stepped(once, "key", 1)), "key").intensity()).isEqualTo(1.2);
        assertThat(Desk.light(Desk.done(Dial.INTENSITY.stepped(once, "key", -4)), "key").intensity()).isEqualTo(0.7);
    }

    @Test
    void click_turnsAnglesByADegree() {
        assertThat(Desk.light(Desk.done(Dial.ANGLE.stepped(scene, "key", 2)), "key").angle()).isEqualTo(27);
    }

    @Test
    void click_stopsAtTheLimits() {
        assertThat(Desk.done(Dial.INTENSITY.stepped(scene, "fill", -20)).light("fill").orElseThrow().intensity()).isZero();
        assertThat(Desk.done(Dial.DEPTH.stepped(scene, "", 100)).picture().depth()).isEqualTo(10);
    }

    @Test
    void typedValue_isTaken() {
        assertThat(Desk.light(Desk.done(Dial.INTENSITY.typed(scene, "key", " 0.4 ")), "key").intensity()).isEqualTo(0.4);
    }

    @Test
    void typedValueBelowZero_isRefusedWithTheReason() {
        assertThat(Dial.INTENSITY.typed(scene, "key", "-3").refusal()).contains("intensity must be ≥ 0, was -3");
    }

    @Test
    void typedWord_isRefusedWithTheReason() {
        assertThat(Dial.ANGLE.typed(scene, "key", "wide").refusal()).contains("angle must be a number, was 'wide'");
    }

    @Test
    void typedNaN_isRefused() {
        assertThat(Dial.RED.typed(scene, "key", "NaN").refusal()).isPresent();
    }

    @Test
    void typedFractionOfABounce_isRefused() {
        assertThat(Dial.DEPTH.typed(scene, "", "2.5").refusal()).contains("depth must be a whole number, was 2.5");
    }

    @Test
    void refusal_changesNothing() {
        assertThat(Dial.ANGLE.set(scene, "key", 181).or(scene)).isSameAs(scene);
    }

    @Test
    void unknownLight_isRefused() {
        assertThat(Dial.INTENSITY.set(scene, "nobody", 1).refusal()).contains("there is no light 'nobody'");
        assertThat(Dial.INTENSITY.stepped(scene, "nobody", 1).refusal()).contains("there is no light 'nobody'");
    }

    @Test
    void attenuationDials_setTheirOwnConstant() {
        Scene edited = Desk.done(Dial.QUADRATIC.set(Desk.done(Dial.LINEAR.set(Desk.done(
                Dial.CONSTANT.set(scene, "fill", 2)), "fill", 3)), "fill", 4));
        assertThat(Desk.light(edited, "fill").attenuation()).isEqualTo(new Attenuation(2, 3, 4));
    }

    @Test
    void spot_hasEveryDial() {
        for (Dial dial : Dial.values()) {
            assertThat(dial.obstacle(scene.light("key"))).isEmpty();
        }
    }

    @Test
    void pointLight_hasNoConeAndNoDirection() {
        assertThat(Dial.ANGLE.obstacle(scene.light("fill"))).contains("a point light has no angle");
        assertThat(Dial.DROPOFF.obstacle(scene.light("fill"))).contains("a point light has no dropoff");
        assertThat(Dial.LINEAR.obstacle(scene.light("fill"))).isEmpty();
        assertThat(Attribute.DIRECTION.obstacle(LightType.POINT)).contains("a point light has no direction");
    }

    @Test
    void directionalLight_hasColorIntensityAndDirectionOnly() {
        assertThat(Arrays.stream(Attribute.values()).filter(a -> a.acts(LightType.DIRECTIONAL)))
                .containsExactly(Attribute.COLOR, Attribute.INTENSITY, Attribute.DIRECTION);
        assertThat(Dial.CONSTANT.obstacle(scene.light("sun"))).contains("a directional light has no attenuation");
    }

    @Test
    void withoutASelection_onlyTheScenesDialsTurn() {
        for (Dial dial : Dial.values()) {
            assertThat(dial.obstacle(Optional.empty()).isEmpty()).isEqualTo(dial == Dial.AMBIENCE || dial == Dial.DEPTH);
        }
    }

    @ParameterizedTest
    @EnumSource(Dial.class)
    void setValue_isTheValueShownAndNothingElseChanges(Dial dial) {
        double other = dial.value(scene, "key") == 3 ? 4 : 3;
        Scene edited = Desk.done(dial.set(scene, "key", other));
        assertThat(dial.value(edited, "key")).isEqualTo(other);
        assertThat(Desk.done(dial.set(edited, "key", dial.value(scene, "key")))).isEqualTo(scene);
    }

    @Property
    void stepsUpAndDown_comeBack(@ForAll @IntRange(max = 100) int steps, @ForAll @DoubleRange(max = 9) double value) {
        double rounded = Math.rint(value * 100) / 100;
        Scene begin = Desk.done(Dial.DROPOFF.set(scene, "key", rounded));
        Scene up = Desk.done(Dial.DROPOFF.stepped(begin, "key", steps));
        assertThat(Desk.done(Dial.DROPOFF.stepped(up, "key", -steps))).isEqualTo(begin);
    }
}
