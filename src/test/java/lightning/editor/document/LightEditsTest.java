package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;

class LightEditsTest {
    private final Scene scene = Desk.scene();

    private Light after(Change change, String name) {
        return Desk.light(Desk.done(change), name);
    }

    private Change aim(String name, Vec3 target) {
        return LightEdits.with(scene, name, l -> LightPlacing.from(l, new LightPlacing.Act.Pool(), target).aimed(target));
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
    void aimAtItself_isRefused() {
        assertThat(aim("key", new Vec3(3, 5, 2)).refusal())
                .contains("the light stands at the point that it should aim at");
    }

    @Test
    void zeroDirection_isRefused() {
        assertThat(LightEdits.with(scene, "key", l -> l.withDirection(Vec3.ZERO)).refusal())
                .contains("direction must not be zero, was 0 0 0");
    }

    @Test
    void typeChange_keepsAllAttributes() {
        Light key = Desk.light(scene, "key");
        Light there = after(LightEdits.type(scene, "key", LightType.DIRECTIONAL), "key");
        assertThat(there.withType(LightType.SPOT)).isEqualTo(key);
    }

    @Test
    void switches_turnOnlyTheirLight() {
        Scene off = Desk.done(LightEdits.on(scene, "fill", false));
        assertThat(Desk.light(off, "fill").on()).isFalse();
        assertThat(Desk.done(LightEdits.on(off, "fill", true))).isEqualTo(scene);
        assertThat(after(LightEdits.solo(scene, "sun", true), "sun").solo()).isTrue();
    }

    @Test
    void rename_keepsThePlaceInTheList() {
        assertThat(Desk.names(Desk.done(LightEdits.rename(scene, "fill", "rim")))).containsExactly("key", "rim", "sun");
    }

    @Test
    void renameToATakenName_isRefused() {
        assertThat(LightEdits.rename(scene, "fill", "ball").refusal()).contains("light 'ball': the name is already taken");
    }

    @Test
    void renameToNoName_isRefused() {
        assertThat(LightEdits.rename(scene, "fill", "a\nb").refusal().orElseThrow()).startsWith("a name must have 1 to 100 characters");
        assertThat(LightEdits.rename(scene, "fill", "").refusal()).isPresent();
    }

    @Test
    void add_isTheLastLightOfItsTypeAndSeesTheScene() {
        Scene added = Desk.done(LightEdits.add(scene, LightType.SPOT));
        assertThat(Desk.names(added)).containsExactly("key", "fill", "sun", "spot");
        Light light = Desk.light(added, "spot");
        assertThat(light.type()).isEqualTo(LightType.SPOT);
        assertThat(light.position().plus(light.direction()).minus(scene.camera().to()).length()).isLessThan(1e-12);
    }

    @Test
    void addingTwice_numbersTheName() {
        Scene twice = Desk.done(LightEdits.add(Desk.done(LightEdits.add(scene, LightType.POINT)), LightType.POINT));
        assertThat(Desk.names(twice)).endsWith("point", "point2");
    }

    @Test
    void delete_takesTheLightAway() {
        assertThat(Desk.names(Desk.done(LightEdits.delete(scene, "fill")))).containsExactly("key", "sun");
        assertThat(LightEdits.delete(scene, "rim").refusal()).contains("there is no light 'rim'");
    }

    @Test
    void duplicate_standsBesideItsOriginalAndIsElseLikeIt() {
        Scene doubled = Desk.done(LightEdits.duplicate(scene, "key"));
        assertThat(Desk.names(doubled)).containsExactly("key", "key2", "fill", "sun");
        Light key = Desk.light(scene, "key");
        Light copy = Desk.light(doubled, "key2");
        assertThat(copy.withName("key").withPosition(key.position())).isEqualTo(key);
        Vec3 way = new Vec3(Beside.length(scene), 0, 0);
        assertThat(copy.position()).isEqualTo(key.position().plus(way));
        Scene tripled = Desk.done(LightEdits.duplicate(doubled, "key2"));
        assertThat(Desk.light(tripled, "key3").position()).isEqualTo(copy.position().plus(way));
    }

    @Test
    void freeNameOfALongOne_cutsNoCharacterInTwo() {
        String name = "a" + "𝐀".repeat(49);
        Scene taken = LightEdits.add(scene, Light.of(name, LightType.POINT)).or(scene);
        assertThat(LightEdits.freeName(taken, name)).isEqualTo(name + "2");
        String longest = "a" + "𝐀".repeat(99);
        assertThat(LightEdits.freeName(taken.withLights(List.of(Light.of(longest, LightType.POINT))), longest))
                .isEqualTo("a" + "𝐀".repeat(92) + "2");
    }

    @Test
    void freeName_passesOverShapesToo() {
        assertThat(LightEdits.freeName(scene, "ball")).isEqualTo("ball2");
        assertThat(LightEdits.freeName(scene, "rim")).isEqualTo("rim");
    }

    @Test
    void freeNameOfTheLongestName_isStillAName() {
        String longest = "a".repeat(100);
        Scene named = Desk.done(LightEdits.rename(scene, "key", longest));
        assertThat(Desk.names(Desk.done(LightEdits.duplicate(named, longest)))).hasSize(4);
    }

    @Test
    void paste_givesSettingsButNotPlaceOrSwitches() {
        Light key = Desk.light(scene, "key").withOn(false);
        Light fill = Desk.light(scene, "fill");
        Light pasted = after(LightEdits.paste(scene, "fill", key), "fill");
        assertThat(pasted).isEqualTo(key.withName("fill").withPosition(fill.position()).withDirection(fill.direction()).withOn(true));
    }

    @Test
    void temperature_keepsTheBrightestChannel() {
        Scene bright = Desk.done(LightEdits.with(scene, "key", l -> l.withColor(new Rgb(0.2, 3, 1))));
        Rgb warm = after(LightEdits.temperature(bright, "key", 2700), "key").color();
        assertThat(warm.max()).isEqualTo(3);
        assertThat(warm.r()).isGreaterThan(warm.g());
        assertThat(warm.g()).isGreaterThan(warm.b());
    }

    @Test
    void temperatureOutsideTheRange_isRefused() {
        assertThat(LightEdits.temperature(scene, "key", 500).refusal()).contains("temperature must be from 1667 to 25000, was 500");
    }

    @Test
    void hsv_setsTheColor() {
        assertThat(after(LightEdits.hsv(scene, "key", new Hsv(120, 1, 2)), "key").color()).isEqualTo(new Rgb(0, 2, 0));
    }
}
