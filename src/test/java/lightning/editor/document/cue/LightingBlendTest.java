package lightning.editor.document.cue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.sample.EditSession;
import lightning.scene.Light;
import lightning.scene.LightGroup;
import lightning.scene.LightRig;
import lightning.scene.LightType;
import lightning.scene.World;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class LightingBlendTest {
    private static final Light KEY = Light.of("key", LightType.SPOT);

    private static Lighting lightingOf(Light... lights) {
        return new Lighting(World.DEFAULT, LightRig.of(List.of(lights)));
    }

    private static Light blend(Light a, Light b, double t) {
        return LightingBlend.blend(lightingOf(a), lightingOf(b), t).rig().lights().getFirst();
    }

    @Provide
    Arbitrary<EditSession> sessions() {
        return EditSession.mixedSessions();
    }

    @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
    void anyTwo_areThemselvesAtTheEndsAndLightTheSceneBetween(@ForAll("sessions") EditSession session,
            @ForAll @DoubleRange(min = 0, max = 1) double t) {
        Lighting a = Lighting.of(session.scenes().getFirst());
        Lighting b = Lighting.of(session.scenes().getLast());
        assertThat(LightingBlend.blend(a, b, 0)).isEqualTo(a);
        assertThat(LightingBlend.blend(a, b, 1)).isEqualTo(b);
        // Creating a scene checks its limits; the blend only adds the names of shapes.
        Lighting blend = LightingBlend.blend(a, b, t);
        assertThat(blend.rig().lights().size()).isLessThanOrEqualTo(a.rig().lights().size() + b.rig().lights().size());
        assertThat(LightingBlend.blend(a, a, t).rig().lights()).hasSameSizeAs(a.rig().lights());
    }

    @Test
    void weight_isLinear() {
        Light light = blend(KEY.withColor(new Rgb(1, 1, 1)).withIntensity(1), KEY.withColor(new Rgb(1, 0, 0)).withIntensity(3), 0.25);
        assertThat(light.intensity()).isEqualTo(1.5);
        assertThat(light.weight().r()).isCloseTo(0.75 * 1 + 0.25 * 3, within(1e-15));
        assertThat(light.weight().g()).isCloseTo(0.75, within(1e-15));
    }

    @Test
    void lightThatIsOff_hasZeroWeight() {
        Light light = blend(KEY.withColor(new Rgb(0, 1, 0)).withIntensity(8).withOn(false), KEY.withIntensity(2), 0.5);
        assertThat(light.on()).isTrue();
        assertThat(light.weight()).isEqualTo(new Rgb(1, 1, 1));
    }

    @Test
    void positionAndAngle_areLinearAndDirectionsRotate() {
        Light light = blend(KEY.withPosition(new Vec3(0, 0, 0)).withAngle(10).withDirection(new Vec3(2, 0, 0)),
                KEY.withPosition(new Vec3(4, 8, 0)).withAngle(30).withDirection(new Vec3(0, 5, 0)), 0.5);
        assertThat(light.position()).isEqualTo(new Vec3(2, 4, 0));
        assertThat(light.angle()).isEqualTo(20);
        assertThat(light.direction().minus(new Vec3(Math.sqrt(0.5), Math.sqrt(0.5), 0)).length()).isLessThan(1e-15);
    }

    @Test
    void oppositeDirections_rotateAtFullLength() {
        Light light = blend(KEY.withDirection(new Vec3(0, -1, 0)), KEY.withDirection(new Vec3(0, 1, 0)), 0.5);
        assertThat(light.direction().length()).isCloseTo(1, within(1e-12));
        assertThat(light.direction().y()).isCloseTo(0, within(1e-12));
    }

    @Test
    void lightOfOtherType_isCrossFadedUnderFreeName() {
        LightRig rig = LightingBlend.blend(lightingOf(KEY), lightingOf(KEY.withType(LightType.POINT)), 0.25).rig();
        assertThat(rig.lights()).extracting(Light::name).containsExactly("key", "key2");
        assertThat(rig.lights()).extracting(Light::type).containsExactly(LightType.SPOT, LightType.POINT);
        assertThat(rig.lights()).extracting(Light::intensity).containsExactly(0.75, 0.25);
    }

    @Test
    void lightsOfOneEnd_fade() {
        LightRig rig = LightingBlend.blend(lightingOf(KEY), lightingOf(KEY.withName("rim")), 0.25).rig();
        assertThat(rig.lights()).extracting(Light::name).containsExactly("key", "rim");
        assertThat(rig.lights()).extracting(Light::intensity).containsExactly(0.75, 0.25);
    }

    @Test
    void differentLightGroups_areFoldedIntoLights() {
        Light member = KEY.withLightGroup("rims");
        var a = new Lighting(World.DEFAULT, LightRig.of(List.of(member), List.of(LightGroup.of("rims").withIntensity(4))));
        var b = new Lighting(World.DEFAULT, LightRig.of(List.of(member), List.of(LightGroup.of("rims").withIntensity(2))));
        LightRig rig = LightingBlend.blend(a, b, 0.5).rig();
        assertThat(rig.lightGroups()).isEmpty();
        assertThat(rig.lights().getFirst().intensity()).isEqualTo(3);
        assertThat(LightingBlend.blend(a, a, 0.5).rig()).isEqualTo(a.rig());
    }

    @Test
    void lightMutedBySolo_hasZeroWeight() {
        LightRig rig =
                LightingBlend.blend(lightingOf(KEY, KEY.withName("fill").withSolo(true)), lightingOf(KEY, KEY.withName("fill")), 0.5).rig();
        assertThat(rig.lights()).extracting(Light::intensity).containsExactly(0.5, 1.0);
        assertThat(rig.lights()).noneMatch(Light::solo);
    }

    @Test
    void ambience_isLinear() {
        var a = new Lighting(World.DEFAULT.withAmbience(1), LightRig.EMPTY);
        var b = new Lighting(World.DEFAULT.withAmbience(0.5), LightRig.EMPTY);
        assertThat(LightingBlend.blend(a, b, 0.5).world().ambience()).isEqualTo(0.75);
    }
}
