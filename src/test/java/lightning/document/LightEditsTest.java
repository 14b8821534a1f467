package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.manipulation.DuplicateOffset;
import lightning.document.manipulation.LightPlacement;
import lightning.document.manipulation.ViewFocus;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LightEditsTest {
    private final Scene scene = DeskScene.scene();

    private Light after(EditOutcome change, String name) {
        return DeskScene.light(DeskScene.sceneOf(change), name);
    }

    private EditOutcome aim(String name, Vec3 target) {
        return LightEdits.edit(scene, name, l -> LightPlacement.start(l, new LightPlacement.Goal.Pool(), target).aimAt(target));
    }

    @Test
    void aim_pointsFromThePositionToTheTarget() {
        Light aimed = after(aim("key", new Vec3(0, 1, 0)), "key");
        assertThat(aimed.position().plus(aimed.direction())).isEqualTo(new Vec3(0, 1, 0));
    }

    @Test
    void aimOfAPointLight_isRefused() {
        assertThat(aim("fill", Vec3.ZERO).refusal()).contains("a point light has no direction");
    }

    @Test
    void aimAtOwnPosition_isRefused() {
        assertThat(aim("key", new Vec3(3, 5, 2)).refusal())
                .contains("the target is at the light's position");
    }

    @Test
    void zeroDirection_isRefused() {
        assertThat(LightEdits.edit(scene, "key", l -> l.withDirection(Vec3.ZERO)).refusal())
                .contains("direction must not be zero, was 0 0 0");
    }

    @Test
    void typeChange_keepsAllAttributes() {
        Light key = DeskScene.light(scene, "key");
        Light there = after(LightEdits.setType(scene, "key", LightType.DIRECTIONAL), "key");
        assertThat(there.withType(LightType.SPOT)).isEqualTo(key);
    }

    @Test
    void switches_affectOnlyTheirLight() {
        Scene off = DeskScene.sceneOf(LightEdits.setOn(scene, "fill", false));
        assertThat(DeskScene.light(off, "fill").on()).isFalse();
        assertThat(DeskScene.sceneOf(LightEdits.setOn(off, "fill", true))).isEqualTo(scene);
        assertThat(after(LightEdits.setSolo(scene, "sun", true), "sun").solo()).isTrue();
    }

    @Test
    void rename_keepsListPosition() {
        assertThat(DeskScene.names(DeskScene.sceneOf(LightEdits.rename(scene, "fill", "rim")))).containsExactly("key", "rim", "sun");
    }

    @Test
    void renameToTakenName_isRefused() {
        assertThat(LightEdits.rename(scene, "fill", "ball").refusal()).contains("light 'ball': the name is already taken");
    }

    @Test
    void renameToEmptyName_isRefused() {
        assertThat(LightEdits.rename(scene, "fill", "a\nb").refusal().orElseThrow()).startsWith("a name must have 1 to 100 characters");
        assertThat(LightEdits.rename(scene, "fill", "").refusal()).isPresent();
    }

    @Test
    void add_appendsLightFacingScene() {
        Scene added = DeskScene.sceneOf(LightEdits.add(scene, LightType.SPOT));
        assertThat(DeskScene.names(added)).containsExactly("key", "fill", "sun", "spot");
        Light light = DeskScene.light(added, "spot");
        assertThat(light.type()).isEqualTo(LightType.SPOT);
        assertThat(light.position().plus(light.direction()).minus(ViewFocus.of(scene)).length()).isLessThan(1e-12);
    }

    /** The same picture at three sizes of the scene, with cameras whose target is one unit away, as in imported files. */
    @ParameterizedTest
    @ValueSource(doubles = {0.005, 1, 1000})
    void newLight_suitsTheScenesSize(double size) throws Exception {
        Scene room = JenReader.read("jen 1 camera { from 0 0 " + 10 * size + " to 0 0 " + (10 * size - 1) + " } sphere ball { scale " + size
                + " " + size + " " + size + " }", "room", Path.of("")).scene();
        for (LightType type : EnumSet.complementOf(EnumSet.of(LightType.OBJECT))) {
            Scene added = DeskScene.sceneOf(LightEdits.add(room, type));
            Light light = added.lights().getLast();
            double distance = light.position().minus(new Vec3(0, 0, size)).length();
            double strength = added.rig().effectiveLight(light).intensity() / (type.hasPosition() ? distance * distance : 1);
            assertThat(strength).as("light on paper at the ball").isBetween(0.96, 1.04);
            assertThat(light.area().width() / size).isBetween(4.0, 5.0);
            assertThat(light.falloff()).isEqualTo(type.hasPosition() ? Falloff.INVERSE_SQUARE : Falloff.CUSTOM);
            Light other = DeskScene.light(DeskScene.sceneOf(LightEdits.setType(added, light.name(), LightType.DIRECTIONAL)), light.name());
            assertThat(other.intensity() * Math.pow(2, other.emission().exposure())).isBetween(0.93, 1.07);
        }
    }

    /** A light as strong as in the dark would burn out what other lights show. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            light sun directional { direction 0 0 -1  intensity 0.125 }                                       | 0.03125
            light sun directional { direction 0 0 -1  intensity 9 }                                           | 0.25
            light dark directional { intensity 3  on no }                                                     | 1
            light dim point { at 0 0 3  intensity 0.5  falloff inverse_square }                               | 0.03125
            light dim spot { at 0 0 3  direction 0 1 0  angle 30 }                                            | 0.25
            light back rect { at 0 0 3  direction 0 0 1 } light low directional { intensity 0.5 }             | 0.125
            picture { exposure 2 }                                                                            | 0.25
            picture { exposure 2 } light sun directional { direction 0 0 -1  intensity 1 }                    | 0.0625
            light sun directional { direction 0 0 -1  intensity 0.000001 }                                    | 0.0009765625
            """)
    void newLight_isAQuarterAsBrightAsTheStrongest(String others, double expected) throws Exception {
        Scene lit = JenReader.read("jen 1 camera { from 0 0 10 to 0 0 1 } sphere ball {} " + others, "lit", Path.of("")).scene();
        for (LightType type : EnumSet.complementOf(EnumSet.of(LightType.OBJECT))) {
            Scene added = DeskScene.sceneOf(LightEdits.add(lit, type));
            Light light = added.lights().getLast();
            double distance = light.position().minus(new Vec3(0, 0, 1)).length();
            double strength = added.rig().effectiveLight(light).intensity() / (type.hasPosition() ? distance * distance : 1);
            assertThat(strength / expected).as("light on paper at the ball, of " + type).isBetween(0.96, 1.04);
        }
    }

    @Test
    void addingTwice_numbersTheName() {
        Scene twice = DeskScene.sceneOf(LightEdits.add(DeskScene.sceneOf(LightEdits.add(scene, LightType.POINT)), LightType.POINT));
        assertThat(DeskScene.names(twice)).endsWith("point", "point2");
    }

    @Test
    void delete_removesLight() {
        assertThat(DeskScene.names(DeskScene.sceneOf(LightEdits.delete(scene, "fill")))).containsExactly("key", "sun");
        assertThat(LightEdits.delete(scene, "rim").refusal()).contains("light 'rim' not found");
    }

    @Test
    void duplicate_differsOnlyInNameAndPosition() {
        Scene doubled = DeskScene.sceneOf(LightEdits.duplicate(scene, "key"));
        assertThat(DeskScene.names(doubled)).containsExactly("key", "key2", "fill", "sun");
        Light key = DeskScene.light(scene, "key");
        Light copy = DeskScene.light(doubled, "key2");
        assertThat(copy.withName("key").withPosition(key.position())).isEqualTo(key);
        Vec3 way = new Vec3(DuplicateOffset.length(scene), 0, 0);
        assertThat(copy.position()).isEqualTo(key.position().plus(way));
        Scene tripled = DeskScene.sceneOf(LightEdits.duplicate(doubled, "key2"));
        assertThat(DeskScene.light(tripled, "key3").position()).isEqualTo(copy.position().plus(way));
    }

    @Test
    void freeNameOfLongName_splitsNoCharacter() {
        String name = "a" + "𝐀".repeat(49);
        Scene taken = LightEdits.add(scene, Light.of(name, LightType.POINT)).sceneOr(scene);
        assertThat(LightEdits.freeName(taken, name)).isEqualTo(name + "2");
        String longest = "a" + "𝐀".repeat(99);
        assertThat(LightEdits.freeName(taken.withLights(List.of(Light.of(longest, LightType.POINT))), longest))
                .isEqualTo("a" + "𝐀".repeat(92) + "2");
    }

    @Test
    void freeName_avoidsShapeNames() {
        assertThat(LightEdits.freeName(scene, "ball")).isEqualTo("ball2");
        assertThat(LightEdits.freeName(scene, "rim")).isEqualTo("rim");
    }

    @Test
    void freeNameOfLongestName_isValid() {
        String longest = "a".repeat(100);
        Scene named = DeskScene.sceneOf(LightEdits.rename(scene, "key", longest));
        assertThat(DeskScene.names(DeskScene.sceneOf(LightEdits.duplicate(named, longest)))).hasSize(4);
    }

    @Test
    void pasteSettings_keepsPositionAndSwitches() {
        Light key = DeskScene.light(scene, "key").withOn(false);
        Light fill = DeskScene.light(scene, "fill");
        Light pasted = after(LightEdits.pasteSettings(scene, "fill", key), "fill");
        assertThat(pasted).isEqualTo(key.withName("fill").withPosition(fill.position()).withDirection(fill.direction()).withOn(true));
    }

    @Test
    void setTemperature_keepsTheColor() {
        Scene bright = DeskScene.sceneOf(LightEdits.edit(scene, "key", l -> l.withColor(new Rgb(0.2, 3, 1))));
        Light warm = after(LightEdits.setTemperature(bright, "key", 2700), "key");
        assertThat(warm.color()).isEqualTo(new Rgb(0.2, 3, 1));
        assertThat(warm.emission().temperature()).isEqualTo(2700);
        assertThat(warm.emission().tinted(Rgb.WHITE).b()).isLessThan(0.5);
    }

    @Test
    void unitChange_keepsBrightness() {
        Scene inches = scene.withWorld(scene.world().withMeters(0.0254));
        Scene lumens = DeskScene.sceneOf(LightEdits.setChoice(inches, "key", LightAttribute.UNIT, IntensityUnit.LUMEN));
        Light before = inches.rig().effectiveLight(DeskScene.light(inches, "key"));
        Light after = lumens.rig().effectiveLight(DeskScene.light(lumens, "key"));
        assertThat(after.intensity()).isCloseTo(before.intensity(), within(1e-12 * before.intensity()));
        assertThat(DeskScene.light(lumens, "key").intensity()).isNotEqualTo(before.intensity());
    }

    @Test
    void inverseSquareFalloff_keepsBrightnessAtTheFocus() {
        Scene changed = DeskScene.sceneOf(LightEdits.setChoice(scene, "key", LightAttribute.FALLOFF, Falloff.INVERSE_SQUARE));
        Light before = DeskScene.light(scene, "key");
        Light light = DeskScene.light(changed, "key");
        double distance = ViewFocus.of(scene).minus(light.position()).length();
        var terms = before.attenuation();
        double wanted = before.intensity()
                * Math.min(1, 1 / (terms.constant() + terms.linear() * distance + terms.quadratic() * distance * distance));
        double effective = changed.rig().effectiveLight(light).intensity() / (distance * distance);
        assertThat(effective / wanted).isBetween(0.96, 1.04);
        assertThat(light.intensity()).isEqualTo(before.intensity());
    }

    @Test
    void temperatureOutsideTheRange_isRefused() {
        assertThat(LightEdits.setTemperature(scene, "key", 500).refusal()).contains("temperature must be from 1667 to 25000, was 500");
    }

    @Test
    void hsv_setsTheColor() {
        assertThat(after(LightEdits.setHsv(scene, "key", new HsvColor(120, 1, 2)), "key").color()).isEqualTo(new Rgb(0, 2, 0));
    }
}
