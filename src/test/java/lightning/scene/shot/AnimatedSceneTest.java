package lightning.scene.shot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.sample.Session;
import lightning.sample.ShotArbitraries;
import lightning.sample.Slow;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.World;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** What an edit at a frame does to the scene and to its keys. */
class AnimatedSceneTest {
    private static final Scene SCENE = new Scene(Picture.DEFAULT, Camera.DEFAULT, World.DEFAULT, Stage.EMPTY, Rig.of(
            List.of(Light.of("key", LightType.SPOT).withIntensity(7), Light.of("fill", LightType.POINT)), List.of(Bank.of("desk"))));
    private static final Track INTENSITY = new Track(Target.light("key"), "intensity",
            List.of(key(10, Passage.SMOOTH, 1), key(20, Passage.LINEAR, 3), key(30, Passage.STEPPED, 2)));
    private static final AnimatedScene MOVING = AnimatedScene.of(SCENE).withShot(new Shot(1, 40, 24, List.of(INTENSITY)));

    record Case(Session session, Shot shot) {}

    @Provide
    Arbitrary<Case> cases() {
        return Session.sessions().flatMap(s -> ShotArbitraries.shots(s.scenes().getFirst()).map(shot -> new Case(s, shot)));
    }

    private static Key key(int frame, Passage passage, double number) {
        return new Key(frame, new Setting.Numbers(List.of(number)), passage);
    }

    private static AnimatedScene lit(int frame, String light, double intensity) {
        Scene shown = MOVING.at(frame);
        return MOVING.edited(frame, shown, shown.withLight(shown.light(light).orElseThrow().withIntensity(intensity)));
    }

    private static List<Key> keys(AnimatedScene scene) {
        return scene.shot().orElseThrow().track(Target.light("key"), "intensity").orElseThrow().keys();
    }

    @Test
    void editOfWhatHasKeys_setsTheKeyAtItsFrame() {
        AnimatedScene edited = lit(20, "key", 5);
        assertThat(keys(edited)).containsExactly(INTENSITY.keys().get(0), key(20, Passage.LINEAR, 5), INTENSITY.keys().get(2));
        assertThat(edited.still()).isEqualTo(SCENE);
    }

    @Test
    void editBetweenKeys_makesOneThatGoesOnAsTheKeyBefore() {
        assertThat(keys(lit(12, "key", 5)).get(1)).isEqualTo(key(12, Passage.SMOOTH, 5));
        assertThat(keys(lit(35, "key", 5)).getLast()).isEqualTo(key(35, Passage.STEPPED, 5));
        assertThat(keys(lit(2, "key", 5)).getFirst()).isEqualTo(key(2, Passage.SMOOTH, 5));
    }

    @Test
    void editOfWhatHasNoKeys_isAtEveryFrame() {
        AnimatedScene edited = lit(12, "fill", 5);
        assertThat(edited.shot()).isEqualTo(MOVING.shot());
        assertThat(edited.still()).isEqualTo(SCENE.withLight(SCENE.light("fill").orElseThrow().withIntensity(5)));
    }

    @Test
    void renamedLight_keepsItsKeysAndTheValueBelowThem() {
        Scene shown = MOVING.at(15);
        AnimatedScene edited = MOVING.edited(15, shown, shown.withLights(
                List.of(shown.lights().getFirst().withName("main"), shown.lights().getLast())));
        assertThat(edited.shot().orElseThrow().tracks()).containsExactly(INTENSITY.of(Target.light("main")));
        assertThat(edited.still().light("main").orElseThrow().intensity()).isEqualTo(7);
    }

    @Test
    void lightThatIsGone_takesItsKeysAlong() {
        Scene shown = MOVING.at(15);
        assertThat(MOVING.edited(15, shown, shown.withLights(List.of())).shot().orElseThrow().tracks()).isEmpty();
    }

    /** Of any edit of the program: the frame is as edited, and what has keys is the same at all frames whose way it does not alter. */
    @Property(tries = 100)
    @Slow
    void edit_isShownAtItsFrame(@ForAll("cases") Case of, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        AnimatedScene scene = AnimatedScene.of(of.session().scenes().getFirst()).withShot(of.shot());
        Optional<Scene> first = at(scene, frame);
        Assume.that(first.isPresent());
        Scene shown = first.get();
        List<Scene> wanted = new ArrayList<>(of.session().scenes());
        for (Scene edited : wanted.subList(1, wanted.size())) {
            Optional<AnimatedScene> next = edited(scene, frame, shown, edited);
            if (next.isPresent()) {
                scene = next.get();
                shown = edited;
                assertThat(scene.at(frame)).isEqualTo(edited);
                scene.shot().orElseThrow().check(scene.still());
            }
        }
    }

    @Property(tries = 100)
    void edit_leavesWhatNobodyTouchedBelowTheKeys(@ForAll("cases") Case of, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        AnimatedScene scene = AnimatedScene.of(of.session().scenes().getFirst()).withShot(of.shot());
        Optional<Scene> shown = at(scene, frame);
        Assume.that(shown.isPresent());
        assertThat(scene.edited(frame, shown.get(), shown.get())).isEqualTo(scene);
    }

    private static Optional<Scene> at(AnimatedScene scene, int frame) {
        try {
            return Optional.of(scene.at(frame));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private static Optional<AnimatedScene> edited(AnimatedScene scene, int frame, Scene shown, Scene edited) {
        try {
            return Optional.of(scene.edited(frame, shown, edited));
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }
}
