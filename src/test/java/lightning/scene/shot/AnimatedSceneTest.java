package lightning.scene.shot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.sample.EditSession;
import lightning.sample.ShotArbitraries;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the effect of an edit at a frame on the scene and its keyframes. */
class AnimatedSceneTest {
    private static final Scene SCENE = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, Stage.EMPTY, LightRig.of(
            List.of(Light.of("key", LightType.SPOT).withIntensity(7), Light.of("fill", LightType.POINT)), List.of(LightGroup.of("desk"))));
    private static final Track INTENSITY = new Track(new SceneElement.OfLight("key"), "intensity",
            List.of(key(10, Interpolation.SMOOTH, 1), key(20, Interpolation.LINEAR, 3), key(30, Interpolation.STEPPED, 2)));
    private static final AnimatedScene MOVING = AnimatedScene.of(SCENE).withShot(new Shot(1, 40, 24, List.of(INTENSITY)));

    record Case(EditSession session, Shot shot) {}

    @Provide
    Arbitrary<Case> cases() {
        return EditSession.mixedSessions().flatMap(s -> ShotArbitraries.shots(s.scenes().getFirst()).map(shot -> new Case(s, shot)));
    }

    private static Keyframe key(int frame, Interpolation passage, double number) {
        return new Keyframe(frame, new KeyframeValue.Numbers(List.of(number)), passage);
    }

    private static AnimatedScene lightAt(int frame, String light, double intensity) {
        Scene shown = MOVING.sceneAt(frame);
        return MOVING.withEdit(frame, shown, shown.withLight(shown.light(light).orElseThrow().withIntensity(intensity)));
    }

    private static List<Keyframe> keys(AnimatedScene scene) {
        return scene.shot().orElseThrow().track(new SceneElement.OfLight("key"), "intensity").orElseThrow().keys();
    }

    @Test
    void keyedAttributeEdit_setsKeyAtFrame() {
        AnimatedScene edited = lightAt(20, "key", 5);
        assertThat(keys(edited)).containsExactly(INTENSITY.keys().get(0), key(20, Interpolation.LINEAR, 5), INTENSITY.keys().get(2));
        assertThat(edited.base()).isEqualTo(SCENE);
    }

    @Test
    void editBetweenKeys_insertsKeyWithSameInterpolation() {
        assertThat(keys(lightAt(12, "key", 5)).get(1)).isEqualTo(key(12, Interpolation.SMOOTH, 5));
        assertThat(keys(lightAt(35, "key", 5)).getLast()).isEqualTo(key(35, Interpolation.STEPPED, 5));
        assertThat(keys(lightAt(2, "key", 5)).getFirst()).isEqualTo(key(2, Interpolation.SMOOTH, 5));
    }

    @Test
    void unkeyedEdit_appliesToAllFrames() {
        AnimatedScene edited = lightAt(12, "fill", 5);
        assertThat(edited.shot()).isEqualTo(MOVING.shot());
        assertThat(edited.base()).isEqualTo(SCENE.withLight(SCENE.light("fill").orElseThrow().withIntensity(5)));
    }

    @Test
    void renamedLight_keepsKeysAndBaseValue() {
        Scene shown = MOVING.sceneAt(15);
        AnimatedScene edited = MOVING.withEdit(15, shown, shown.withLights(
                List.of(shown.lights().getFirst().withName("main"), shown.lights().getLast())));
        assertThat(edited.shot().orElseThrow().tracks()).containsExactly(INTENSITY.withTarget(new SceneElement.OfLight("main")));
        assertThat(edited.base().light("main").orElseThrow().intensity()).isEqualTo(7);
    }

    @Test
    void deletedLight_losesItsKeys() {
        Scene shown = MOVING.sceneAt(15);
        assertThat(MOVING.withEdit(15, shown, shown.withLights(List.of())).shot().orElseThrow().tracks()).isEmpty();
    }

    /**
     * After any edit, the frame is as edited, and animated attributes are unchanged at all frames that the new keyframe does not affect.
     */
    @Property(tries = 100)
    @Slow
    void edit_isVisibleAtItsFrame(@ForAll("cases") Case of, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        AnimatedScene scene = AnimatedScene.of(of.session().scenes().getFirst()).withShot(of.shot());
        Optional<Scene> first = at(scene, frame);
        Assume.that(first.isPresent());
        Scene shown = first.get();
        List<Scene> expected = new ArrayList<>(of.session().scenes());
        for (Scene edited : expected.subList(1, expected.size())) {
            Optional<AnimatedScene> next = edited(scene, frame, shown, edited);
            if (next.isPresent()) {
                scene = next.get();
                shown = edited;
                assertThat(scene.sceneAt(frame)).isEqualTo(edited);
                scene.shot().orElseThrow().check(scene.base());
            }
        }
    }

    @Property(tries = 100)
    void edit_keepsUntouchedBaseValues(@ForAll("cases") Case of, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        AnimatedScene scene = AnimatedScene.of(of.session().scenes().getFirst()).withShot(of.shot());
        Optional<Scene> shown = at(scene, frame);
        Assume.that(shown.isPresent());
        assertThat(scene.withEdit(frame, shown.get(), shown.get())).isEqualTo(scene);
    }

    private static Optional<Scene> at(AnimatedScene scene, int frame) {
        try {
            return Optional.of(scene.sceneAt(frame));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static Optional<AnimatedScene> edited(AnimatedScene scene, int frame, Scene shown, Scene edited) {
        try {
            return Optional.of(scene.withEdit(frame, shown, edited));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }
}
