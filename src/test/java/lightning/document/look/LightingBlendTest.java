package lightning.document.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.sample.EditSession;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.sky.Sky;
import lightning.scene.value.DomeRotation;
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

    @Test
    void sunOfSky_movesAtItsBrightness() {
        World morning =
                World.DEFAULT.withSky(Sky.NONE.with(sky -> sky.on(true).elevation(10).azimuth(90))).withOwn(own -> own.withIntensity(2));
        World noon = morning.withSky(morning.sky().with(sky -> sky.elevation(50).azimuth(180)));
        LightRig rig = LightRig.of(List.of(KEY));
        World between = LightingBlend.blend(new Lighting(morning, rig), new Lighting(noon, rig), 0.25).world();
        assertThat(between.sky()).isEqualTo(morning.sky().with(sky -> sky.elevation(20).azimuth(112.5)));
        assertThat(between.own().intensity()).isEqualTo(2);
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

    /** Two faces in one place: the camera would see only the first, which is dark at the end of the second. */
    @Test
    void otherTextureOnVisibleFace_showsFaceOfNearerEnd() {
        Light first = LightAttribute.VISIBLE.with(Light.of("screen", LightType.RECT), true);
        Light last = first.withTexture(Optional.of(new LightTexture("screen.png", new Texture(1, 1, new float[] {1, 0, 0}))));
        assertThat(visibleLights(LightingBlend.blend(lightingOf(first), lightingOf(last), 0.25))).containsExactly("screen");
        assertThat(visibleLights(LightingBlend.blend(lightingOf(first), lightingOf(last), 0.5))).containsExactly("screen2");
        assertThat(visibleLights(LightingBlend.blend(lightingOf(first), lightingOf(last), 0.75))).containsExactly("screen2");
        assertThat(visibleLights(LightingBlend.blend(lightingOf(first), lightingOf(last.withPosition(new Vec3(5, 5, 5))), 0.25)))
                .as("in other places").containsExactly("screen", "screen2");
    }

    private static List<String> visibleLights(Lighting lighting) {
        return lighting.rig().lights().stream().filter(LightAttribute.VISIBLE::get).map(Light::name).toList();
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

    private static final Light FILL = KEY.withName("fill");

    private static Environment environment(float value) {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, value);
        return new Environment("sky" + value + ".hdr", new EnvironmentMap(8, 4, rgb));
    }

    private static Scene scene(Lighting lighting) {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, lighting.world(), Stage.EMPTY, lighting.rig());
    }

    /** Returns a lighting with an environment of intensity 2. */
    private static Lighting withEnvironment(boolean isSolo, float value, Light... lights) {
        World world = World.DEFAULT.withEnvironment(Optional.of(environment(value))).withOwn(own -> own.withIntensity(2).withSolo(isSolo));
        return Lighting.of(scene(new Lighting(world, LightRig.of(List.of(lights)))));
    }

    private static Scene blendScene(Lighting a, Lighting b, double t) {
        return scene(LightingBlend.blend(a, b, t));
    }

    /** Returns the factor of the environment's light; 0 if it is muted. */
    private static double environmentLight(Scene scene) {
        LightRig rig = scene.rig();
        return rig.isActive(rig.effectiveLights().getLast()) ? scene.world().own().lightIntensity() : 0;
    }

    private static double weight(Scene scene, String light) {
        return scene.light(light).filter(scene::isActive).map(l -> scene.rig().effectiveLight(l).weight().r()).orElse(0.0);
    }

    @Test
    void soloOfBothEnds_stays() {
        Lighting a = withEnvironment(false, 1, KEY.withSolo(true), FILL);
        Lighting b = withEnvironment(false, 1, KEY.withSolo(true).withIntensity(3), FILL.withIntensity(5));
        Scene scene = blendScene(a, b, 0.25);
        assertThat(environmentLight(scene)).isZero();
        assertThat(scene.world().own().intensity()).as("of the background").isEqualTo(2);
        assertThat(weight(scene, "key")).isEqualTo(1.5);
        assertThat(weight(scene, "fill")).isZero();
        assertThat(scene.lights()).extracting(Light::solo).containsExactly(true, false);
        assertThat(scene.lights().getLast()).as("behind the solo").isEqualTo(FILL.withIntensity(2));
    }

    @Test
    void soloOfOtherLight_keepsEnvironmentMuted() {
        Scene scene = blendScene(withEnvironment(false, 1, KEY.withSolo(true), FILL), withEnvironment(false, 1, KEY, FILL.withSolo(true)),
                0.25);
        assertThat(environmentLight(scene)).isZero();
        assertThat(scene.world().own().intensity()).isEqualTo(2);
        assertThat(weight(scene, "key")).isEqualTo(0.75);
        assertThat(weight(scene, "fill")).isEqualTo(0.25);
    }

    @Test
    void soloOfOneEnd_fadesEnvironment() {
        Lighting solo = withEnvironment(false, 1, KEY.withSolo(true), FILL);
        Lighting none = withEnvironment(false, 1, KEY, FILL);
        Scene scene = blendScene(solo, none, 0.25);
        assertThat(environmentLight(scene)).isEqualTo(0.5);
        assertThat(weight(scene, "key")).isEqualTo(1);
        assertThat(weight(scene, "fill")).isEqualTo(0.25);
        assertThat(scene.world().own().intensity()).as("of the background").isEqualTo(2);
        assertThat(environmentLight(blendScene(none, solo, 0.25))).isEqualTo(1.5);
    }

    @Test
    void soloOfOneEnd_doesNotJumpAtItsEnd() {
        Lighting solo = withEnvironment(false, 1, KEY.withSolo(true), FILL);
        Lighting none = withEnvironment(false, 1, KEY, FILL);
        for (double t : new double[] {0, 1e-9}) {
            assertThat(environmentLight(blendScene(solo, none, t))).as("light at %s", t).isCloseTo(0, within(1e-8));
            assertThat(blendScene(solo, none, t).world().own().intensity()).as("image at %s", t).isCloseTo(2, within(1e-8));
            assertThat(environmentLight(blendScene(none, solo, t))).as("light at %s", t).isCloseTo(2, within(1e-8));
            assertThat(blendScene(none, solo, t).world().own().intensity()).as("image at %s", t).isCloseTo(2, within(1e-8));
        }
    }

    @Test
    void imageAndLightOfEnvironment_areLinear() {
        Lighting a = withEnvironment(false, 1);
        Lighting dimLight = new Lighting(a.world().withOwn(own -> own.withIntensity(4).withGain(0.25)), a.rig());
        Scene scene = blendScene(new Lighting(a.world().withOwn(own -> own.withGain(3)), a.rig()), dimLight, 0.25);
        assertThat(scene.world().own().intensity()).isEqualTo(2.5);
        assertThat(environmentLight(scene)).isCloseTo(0.75 * 6 + 0.25 * 1, within(1e-15));
    }

    /** A dark image has no light, whatever its gain: at that end the light fades in with the image. */
    @Test
    void darkEnvironment_keepsGainOfOtherEnd() {
        Lighting a = withEnvironment(false, 1);
        Scene scene = blendScene(new Lighting(a.world().withOwn(own -> own.withIntensity(0).withGain(9)), a.rig()),
                new Lighting(a.world().withOwn(own -> own.withGain(0.5)), a.rig()), 0.25);
        assertThat(scene.world().own().intensity()).isEqualTo(0.5);
        assertThat(scene.world().own().gain()).isEqualTo(0.5);
    }

    @Test
    void soloOfEnvironment_isThatOfALight() {
        Lighting solo = withEnvironment(true, 1, KEY);
        Scene same = blendScene(solo, solo, 0.5);
        assertThat(same.world().own().solo()).isTrue();
        assertThat(same.lights()).containsExactly(KEY);
        Scene half = blendScene(solo, withEnvironment(false, 1, KEY), 0.25);
        assertThat(environmentLight(half)).isEqualTo(2);
        assertThat(weight(half, "key")).isEqualTo(0.25);
        Scene toKey = blendScene(solo, withEnvironment(false, 1, KEY.withSolo(true)), 0.25);
        assertThat(environmentLight(toKey)).isEqualTo(1.5);
        assertThat(weight(toKey, "key")).isEqualTo(0.25);
    }

    /** As environments with names do: the light of both is linear in the position. */
    @Test
    void otherImages_areBothShownInBetween() {
        Scene scene = blendScene(withEnvironment(false, 1), withEnvironment(false, 7), 0.25);
        assertThat(scene.world().environments()).extracting(dome -> dome.image().orElseThrow().file()).containsExactly("sky1.0.hdr",
                "sky7.0.hdr");
        assertThat(scene.world().environments()).extracting(Dome::intensity).containsExactly(1.5, 0.5);
        assertThat(scene.world().named()).extracting(Dome::name).containsExactly("environment2");
        assertThat(blendScene(withEnvironment(false, 1), withEnvironment(false, 7), 1).world().named()).isEmpty();
    }

    @Test
    void noEnvironment_leadsToTheImageOfTheOtherEnd() {
        Lighting none = Lighting.of(scene(new Lighting(World.DEFAULT, LightRig.EMPTY)));
        assertThat(blendScene(none, withEnvironment(false, 7), 0.25).world().hasEnvironment()).isFalse();
        Scene scene = blendScene(none, withEnvironment(false, 7), 0.75);
        assertThat(scene.world().own().intensity()).isEqualTo(1);
        assertThat(scene.world().named()).isEmpty();
    }

    @Test
    void otherEnvironments_stayMutedAsAtTheirEnd() {
        Lighting solo = withEnvironment(false, 1, KEY.withSolo(true), FILL);
        Lighting none = withEnvironment(false, 7, KEY, FILL);
        Scene scene = blendScene(solo, none, 0.25);
        assertThat(environmentLight(scene)).isZero();
        assertThat(scene.world().own().intensity()).isEqualTo(1.5);
        assertThat(scene.world().named()).extracting(Dome::lightIntensity).containsExactly(0.5);
        assertThat(weight(scene, "fill")).isEqualTo(0.25);
    }

    @Test
    void soloOfLightGroup_mutesOnlyAtItsEnd() {
        LightGroup group = LightGroup.of("rims").withSolo(true);
        Light rim = FILL.withLightGroup("rims");
        World world = withEnvironment(false, 1).world();
        Lighting a = Lighting.of(scene(new Lighting(world, LightRig.of(List.of(KEY, rim), List.of(group)))));
        Lighting b = Lighting.of(scene(new Lighting(world, LightRig.of(List.of(KEY.withSolo(true), rim), List.of(group)))));
        Scene same = blendScene(a, a, 0.25);
        assertThat(same.rig()).isEqualTo(scene(a).rig());
        assertThat(environmentLight(same)).isZero();
        Scene scene = blendScene(a, b, 0.25);
        assertThat(environmentLight(scene)).isZero();
        assertThat(weight(scene, "key")).isEqualTo(0.25);
        assertThat(weight(scene, "fill")).isEqualTo(1);
    }

    @Test
    void ambience_isLinear() {
        var a = new Lighting(World.DEFAULT.withAmbience(1), LightRig.EMPTY);
        var b = new Lighting(World.DEFAULT.withAmbience(0.5), LightRig.EMPTY);
        assertThat(LightingBlend.blend(a, b, 0.5).world().ambience()).isEqualTo(0.75);
    }

    private static Dome dome(String name, float value) {
        float[] rgb = new float[3 * 8];
        Arrays.fill(rgb, value);
        return Dome.of(name).withImage(Optional.of(new Environment(name + value, new EnvironmentMap(4, 2, rgb))));
    }

    private static Lighting withDomes(Dome... domes) {
        return new Lighting(World.DEFAULT.withNamed(List.of(domes)), LightRig.EMPTY);
    }

    @Test
    void domeAtBothEnds_isInterpolated() {
        Dome sky = dome("sky", 1);
        Scene scene = blendScene(withDomes(sky.withRotation(DomeRotation.of(10, 0, 0))),
                withDomes(sky.withIntensity(3).withGain(2).withRotation(DomeRotation.of(50, 20, 0))), 0.25);
        Dome blended = scene.world().named().getFirst();
        assertThat(scene.world().named()).hasSize(1);
        assertThat(blended.intensity()).isEqualTo(1.5);
        assertThat(blended.intensity() * blended.gain()).isCloseTo(0.75 + 0.25 * 6, within(1e-15));
        assertThat(blended.rotation()).isEqualTo(DomeRotation.of(20, 5, 0));
    }

    @Test
    void otherDomes_fadeOutAndIn() {
        Scene scene = blendScene(withDomes(dome("day", 1), dome("studio", 1)), withDomes(dome("night", 2), dome("studio", 3)), 0.25);
        assertThat(scene.world().named()).extracting(Dome::name).containsExactly("day", "studio", "studio2", "night");
        assertThat(scene.world().named()).extracting(Dome::intensity).containsExactly(0.75, 0.75, 0.25, 0.25);
    }

    @Test
    void domeThatIsOffAtOneEnd_fadesIn() {
        Dome sky = dome("sky", 1).withIntensity(2);
        Dome blended = blendScene(withDomes(sky.withOn(false)), withDomes(sky), 0.25).world().named().getFirst();
        assertThat(blended.on()).isTrue();
        assertThat(blended.intensity()).isEqualTo(0.5);
    }

    /** A solo without light mutes nothing, and must not when the dome is lit between. */
    @Test
    void soloOfADarkDome_staysWithoutEffect() {
        Dome sky = dome("sky", 1);
        Scene scene = blendScene(withDomes(sky.withIntensity(0).withSolo(true)), withDomes(sky), 0.5);
        assertThat(scene.world().named()).extracting(Dome::solo).containsExactly(false);
    }

    @Test
    void soloOfADome_fadesWhatItMutes() {
        Dome sky = dome("sky", 1);
        Dome studio = dome("studio", 1);
        Scene scene = blendScene(withDomes(sky.withSolo(true), studio), withDomes(sky, studio), 0.25);
        assertThat(scene.world().named()).extracting(Dome::solo).containsExactly(false, false);
        assertThat(scene.world().named()).extracting(Dome::gain).containsExactly(1.0, 0.25);
        assertThat(scene.world().named()).extracting(Dome::intensity).containsExactly(1.0, 1.0);
        assertThat(blendScene(withDomes(sky.withSolo(true), studio), withDomes(sky.withSolo(true), studio), 0.5).world().named())
                .containsExactly(sky.withSolo(true), studio);
    }
}
