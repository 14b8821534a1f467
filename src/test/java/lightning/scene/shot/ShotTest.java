package lightning.scene.shot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Vec3;
import lightning.sample.SceneArbitraries;
import lightning.sample.ShotArbitraries;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Camera;
import lightning.scene.Choice;
import lightning.scene.Group;
import lightning.scene.Keying;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Picture;
import lightning.scene.Placement;
import lightning.scene.Quantity;
import lightning.scene.Rig;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.Stage;
import lightning.scene.ValueKind;
import lightning.scene.World;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** What a scene is at each frame of a shot. */
class ShotTest {
    private static final Node BALL = new Shape(new Solid.Frustum(0.5, true), "ball", Material.DEFAULT.name(), Placement.IDENTITY);
    private static final Scene SCENE = new Scene(Picture.DEFAULT, Camera.DEFAULT, World.DEFAULT,
            new Stage(List.of(), List.of(new Group("all", Placement.IDENTITY, List.of(BALL)))),
            Rig.of(List.of(Light.of("key", LightType.SPOT), Light.of("fill", LightType.POINT)), List.of(Bank.of("desk"))));

    record Case(Scene scene, Shot shot) {}

    @Provide
    Arbitrary<Case> cases() {
        return SceneArbitraries.scenes().flatMap(scene -> ShotArbitraries.shots(scene).map(shot -> new Case(scene, shot)));
    }

    private static Key key(int frame, Passage passage, double... numbers) {
        return new Key(frame, new Setting.Numbers(java.util.Arrays.stream(numbers).boxed().toList()), passage);
    }

    private static Key word(int frame, String text) {
        return new Key(frame, new Setting.Word(text), Passage.STEPPED);
    }

    private static Scene at(int frame, Track... tracks) {
        Shot shot = Shot.DEFAULT.withTracks(List.of(tracks));
        shot.check(SCENE);
        return shot.at(SCENE, frame);
    }

    private static double intensity(int frame, Key... keys) {
        return at(frame, new Track(Target.light("key"), "intensity", List.of(keys))).light("key").orElseThrow().intensity();
    }

    @Test
    void linear_goesEvenly() {
        Key[] keys = {key(10, Passage.LINEAR, 1), key(14, Passage.LINEAR, 3)};
        assertThat(IntStream.rangeClosed(9, 15).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(1, 1, 1.5, 2, 2.5, 3, 3);
    }

    @Test
    void betweenTwoFrames_itGoesEvenlyToo() {
        Track track = new Track(Target.light("key"), "intensity", List.of(key(10, Passage.LINEAR, 1), key(14, Passage.LINEAR, 3)));
        Shot shot = Shot.DEFAULT.withTracks(List.of(track));
        assertThat(shot.at(SCENE, 11.5).light("key").orElseThrow().intensity()).isEqualTo(1.75);
        assertThat(shot.at(SCENE, 13.75).light("key").orElseThrow().intensity()).isEqualTo(2.875);
    }

    @Test
    void stepped_holdsUntilTheNextKey() {
        Key[] keys = {key(10, Passage.STEPPED, 1), key(12, Passage.STEPPED, 3)};
        assertThat(IntStream.rangeClosed(9, 13).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(1, 1, 1, 3, 3);
    }

    @Test
    void smoothBetweenTwoKeys_isTheCubicThatIsFlatAtBoth() {
        Key[] keys = {key(0, Passage.SMOOTH, 0), key(4, Passage.LINEAR, 1)};
        assertThat(IntStream.rangeClosed(0, 4).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(0, 0.15625, 0.5, 0.84375, 1);
    }

    @Test
    void smoothThroughEvenlySpacedKeysOnALine_hasTheLinesSlopeInside() {
        Key[] keys = {key(0, Passage.SMOOTH, 0), key(10, Passage.SMOOTH, 10), key(20, Passage.SMOOTH, 20), key(30, Passage.SMOOTH, 30)};
        assertThat(IntStream.rangeClosed(10, 20).mapToDouble(f -> intensity(f, keys)).toArray())
                .containsExactly(IntStream.rangeClosed(10, 20).mapToDouble(f -> f).toArray(), org.assertj.core.data.Offset.offset(1e-13));
    }

    @Test
    void direction_turnsOnTheShorterArc() {
        Track quarter =
                new Track(Target.light("key"), "direction", List.of(key(0, Passage.LINEAR, 1, 0, 0), key(2, Passage.LINEAR, 0, 3, 0)));
        Vec3 half = at(1, quarter).light("key").orElseThrow().direction();
        assertThat(half.x()).isCloseTo(Math.sqrt(2), org.assertj.core.data.Offset.offset(1e-15));
        assertThat(half.y()).isCloseTo(Math.sqrt(2), org.assertj.core.data.Offset.offset(1e-15));
    }

    @Test
    void everyTarget_isMoved() {
        Scene scene = at(5, new Track(Target.CAMERA, "fov", List.of(key(5, Passage.LINEAR, 20))),
                new Track(Target.light("fill"), "on", List.of(word(0, "no"))),
                new Track(Target.bank("desk"), "intensity", List.of(key(5, Passage.LINEAR, 0.5))),
                new Track(Target.node("all"), "at", List.of(key(5, Passage.LINEAR, 1, 2, 3))),
                new Track(Target.node("ball"), "top", List.of(key(5, Passage.LINEAR, 0.25))),
                new Track(Target.node("ball"), "visible", List.of(word(5, "no"))));
        assertThat(scene.camera().fov()).isEqualTo(20);
        assertThat(scene.light("fill").orElseThrow().on()).isFalse();
        assertThat(scene.rig().bank("desk").orElseThrow().intensity()).isEqualTo(0.5);
        assertThat(scene.nodes()).containsExactly(new Group("all", Placement.IDENTITY.withAt(new Vec3(1, 2, 3)),
                List.of(((Shape) BALL).withSolid(new Solid.Frustum(0.25, true)).withVisible(false))));
    }

    @Test
    void cameraWhoseEndsPassEachOther_isSetAtOnce() {
        Camera camera = at(5, new Track(Target.CAMERA, "from", List.of(key(5, Passage.LINEAR, 0, 0, 0))),
                new Track(Target.CAMERA, "to", List.of(key(5, Passage.LINEAR, 0, 0, 10)))).camera();
        assertThat(camera).isEqualTo(new Camera(Vec3.ZERO, new Vec3(0, 0, 10), Vec3.Y, Camera.DEFAULT.fov()));
    }

    @Test
    void keysOfLightsAlone_shareTheStage() {
        assertThat(at(5, new Track(Target.light("key"), "angle", List.of(key(5, Passage.LINEAR, 12)))).stage()).isSameAs(SCENE.stage());
    }

    @Test
    void frameThatIsNoScene_isToldWithItsNumber() {
        Track through = new Track(Target.node("ball"), "scale", List.of(key(0, Passage.LINEAR, 1, 1, 1), key(2, Passage.LINEAR, -1, 1, 1)));
        assertThatThrownBy(() -> at(1, through)).isInstanceOf(IllegalArgumentException.class).hasMessage(
                "frame 1: shape or group 'ball': scale must be at least 1e-9 in absolute value on every axis, was 0");
        Track blind = new Track(Target.CAMERA, "from", List.of(key(0, Passage.LINEAR, 0, 0, 0)));
        assertThatThrownBy(() -> at(7, blind)).hasMessage("frame 7: from and to must be two different points");
    }

    @Test
    void whatHasNoKeys_isRefused() {
        assertRefused("there is no light 'rim'", new Track(Target.light("rim"), "intensity", List.of(key(0, Passage.LINEAR, 1))));
        assertRefused("has no top", new Track(Target.node("all"), "top", List.of(key(0, Passage.LINEAR, 1))));
        assertRefused("only numbers and words", new Track(Target.light("key"), "bank", List.of(word(0, "desk"))));
        assertRefused("must be stepped", new Track(Target.light("key"), "samples", List.of(key(0, Passage.LINEAR, 9))));
        assertRefused("intensity must be ≥ 0", new Track(Target.light("key"), "intensity", List.of(key(0, Passage.LINEAR, -1))));
        assertRefused("cannot be", new Track(Target.light("key"), "at", List.of(key(0, Passage.LINEAR, 1))));
        assertThatThrownBy(() -> new Track(Target.CAMERA, "fov", List.of(key(3, Passage.LINEAR, 9), key(3, Passage.LINEAR, 9))))
                .hasMessageContaining("found 3 behind 3");
        Track once = new Track(Target.CAMERA, "fov", List.of(key(3, Passage.LINEAR, 9)));
        assertThatThrownBy(() -> Shot.DEFAULT.withTracks(List.of(once, once))).hasMessageContaining("once");
    }

    private static void assertRefused(String sentence, Track track) {
        assertThatThrownBy(() -> track.check(SCENE)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining(sentence);
    }

    @Property
    void atEveryKey_theValueIsTheKeysInEveryBit(@ForAll("cases") Case c) {
        for (Track track : c.shot.tracks()) {
            Attribute<?, ?> attribute = attribute(c.scene, track);
            for (Key key : track.keys()) {
                assertThat(setting(attribute.kind(), track, key.frame())).isEqualTo(key.setting());
            }
        }
    }

    @Property
    void betweenKeys_noNumberLeavesThoseOfItsNeighbours(@ForAll("cases") Case c, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        for (Track track : c.shot.tracks()) {
            Attribute<?, ?> attribute = attribute(c.scene, track);
            Key before = track.keys().stream().filter(k -> k.frame() <= frame).reduce((_, b) -> b).orElse(track.keys().getFirst());
            Key after = track.keys().stream().filter(k -> k.frame() >= frame).findFirst().orElse(track.keys().getLast());
            if (!(attribute.kind() instanceof Quantity<?> q && q.form() == Quantity.Form.DIRECTION)
                    && setting(attribute.kind(), track, frame) instanceof Setting.Numbers(List<Double> all)) {
                for (int i = 0; i < all.size(); i++) {
                    double a = ((Setting.Numbers) before.setting()).all().get(i);
                    double b = ((Setting.Numbers) after.setting()).all().get(i);
                    assertThat(all.get(i)).isBetween(Math.min(a, b), Math.max(a, b));
                }
            }
        }
    }

    @Property
    void whatHasNoKeys_isAsInTheScene(@ForAll("cases") Case c, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        Scene scene;
        try {
            scene = c.shot.at(c.scene, frame);
        } catch (IllegalArgumentException e) {
            Assume.that(false);
            return;
        }
        for (Light light : c.scene.lights()) {
            for (LightAttribute<?> attribute : LightAttribute.ALL) {
                if (c.shot.track(Target.light(light.name()), attribute.name()).isEmpty()) {
                    assertThat(attribute.of(scene.light(light.name()).orElseThrow())).isEqualTo(attribute.of(light));
                }
            }
        }
        assertThat(scene.materials()).isEqualTo(c.scene.materials());
    }

    @Property
    void smooth_isMonotoneAndItsSlopeIsContinuous(@ForAll @DoubleRange(min = -8, max = 8) double a,
            @ForAll @DoubleRange(min = -8, max = 8) double b,
            @ForAll @DoubleRange(min = -8, max = 8) double c, @ForAll @DoubleRange(min = -8, max = 8) double d,
            @ForAll @IntRange(min = 1, max = 100) int h, @ForAll @IntRange(min = 1, max = 100) int k,
            @ForAll @IntRange(min = 1, max = 100) int l) {
        double atB = Between.slope(a, b, c, h, k);
        double atC = Between.slope(b, c, d, k, l);
        double last = b;
        for (int i = 1; i <= 64; i++) {
            double v = Between.smooth(b, c, atB, atC, k, i / 64.0);
            assertThat((v - last) * Math.signum(c - b)).isGreaterThanOrEqualTo(-4 * Math.ulp(8.0));
            last = v;
        }
        // The derivative, by a difference small beside the interval, is the slope at the key from both sides.
        double e = 0x1p-20;
        double before = (b - Between.smooth(a, b, 0, atB, h, 1 - e)) / (e * h);
        double after = (Between.smooth(b, c, atB, atC, k, e) - b) / (e * k);
        assertThat(before).isCloseTo(atB, org.assertj.core.data.Offset.offset(1e-3));
        assertThat(after).isCloseTo(atB, org.assertj.core.data.Offset.offset(1e-3));
    }

    @Property
    void smoothOfHugeNumbers_staysFinite(@ForAll @DoubleRange(max = 1e30) double a, @ForAll @IntRange(min = -320, max = 30) int power,
            @ForAll @DoubleRange(max = 1) double t) {
        double b = Math.pow(10, power);
        assertThat(Between.smooth(a, b, Between.slope(0, a, b, 1, 9), Between.slope(a, b, 1e30, 9, 1e9), 9, t)).isFinite();
    }

    @Provide
    Arbitrary<ValueKind<?>> kinds() {
        return Arbitraries.of(LightAttribute.ALL).map(Attribute::kind);
    }

    @Property
    void numbersAndWordsAlone_haveKeys(@ForAll("kinds") ValueKind<?> kind) {
        assertThat(kind.keying() == Keying.NONE).isEqualTo(!(kind instanceof Quantity<?> || kind instanceof Choice<?>));
    }

    private static Attribute<?, ?> attribute(Scene scene, Track track) {
        return track.target().attributes(scene).stream().filter(a -> a.name().equals(track.attribute())).findFirst().orElseThrow();
    }

    private static <V> Setting setting(ValueKind<V> kind, Track track, int frame) {
        V value = track.at(frame, kind);
        return switch (kind) {
            case Quantity<V> q -> new Setting.Numbers(q.split().apply(value));
            case Choice<V> w -> new Setting.Word(w.text(value));
            case ValueKind.Filed<?> _,ValueKind.Linking _,ValueKind.Naming _,ValueKind.Texturing _ -> throw new AssertionError();
        };
    }
}
