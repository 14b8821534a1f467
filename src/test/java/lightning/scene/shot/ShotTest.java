package lightning.scene.shot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.sample.IndirectArbitraries;
import lightning.sample.ShotArbitraries;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Tests the scene at each frame of a shot. */
class ShotTest {
    private static final SceneNode BALL = new Shape(new Solid.Frustum(0.5, true), "ball", Material.DEFAULT.name(), Placement.IDENTITY);
    private static final Scene SCENE = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT,
            new Stage(List.of(), List.of(new NodeGroup("all", Placement.IDENTITY, List.of(BALL)))),
            LightRig.of(List.of(Light.of("key", LightType.SPOT), Light.of("fill", LightType.POINT)), List.of(LightGroup.of("desk"))));

    record Case(Scene scene, Shot shot) {}

    @Provide
    Arbitrary<Case> cases() {
        return IndirectArbitraries.mixedScenes().flatMap(scene -> ShotArbitraries.shots(scene).map(shot -> new Case(scene, shot)));
    }

    private static Keyframe key(int frame, Interpolation passage, double... numbers) {
        return new Keyframe(frame, new KeyframeValue.Numbers(java.util.Arrays.stream(numbers).boxed().toList()), passage);
    }

    private static Keyframe word(int frame, String text) {
        return new Keyframe(frame, new KeyframeValue.Word(text), Interpolation.STEPPED);
    }

    private static Scene valueAt(int frame, Track... tracks) {
        Shot shot = Shot.DEFAULT.withTracks(List.of(tracks));
        shot.check(SCENE);
        return shot.sceneAt(SCENE, frame);
    }

    @Test
    void keysOfTheWorld_turnItsEnvironment_andDimAmbientLight() {
        World world = valueAt(24,
                new Track(SceneElement.WORLD, "rotation", List.of(key(0, Interpolation.LINEAR, 0), key(48, Interpolation.LINEAR, 90))),
                new Track(SceneElement.WORLD, "ambience", List.of(key(0, Interpolation.LINEAR, 1), key(32, Interpolation.LINEAR, 0))))
                .world();
        assertThat(World.ROTATION.get(world)).isEqualTo(45);
        assertThat(world.ambience()).isEqualTo(0.25);
    }

    @Test
    void keysOfTheWorld_andOfADome_actTogether() {
        Scene scene = SCENE.withWorld(World.DEFAULT.withNamed(List.of(Dome.of("sky"))));
        Shot shot = Shot.DEFAULT.withTracks(List.of(new Track(SceneElement.WORLD, "intensity", List.of(key(0, Interpolation.LINEAR, 0.5))),
                new Track(new SceneElement.OfDome("sky"), "intensity", List.of(key(0, Interpolation.LINEAR, 0.25)))));
        World world = shot.sceneAt(scene, 3).world();
        assertThat(world.own().intensity()).isEqualTo(0.5);
        assertThat(world.named()).extracting(Dome::intensity).containsExactly(0.25);
    }

    private static double intensity(int frame, Keyframe... keys) {
        return valueAt(frame, new Track(new SceneElement.OfLight("key"), "intensity", List.of(keys))).light("key").orElseThrow()
                .intensity();
    }

    @Test
    void linear_interpolatesEvenly() {
        Keyframe[] keys = {key(10, Interpolation.LINEAR, 1), key(14, Interpolation.LINEAR, 3)};
        assertThat(IntStream.rangeClosed(9, 15).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(1, 1, 1.5, 2, 2.5, 3, 3);
    }

    @Test
    void fractionalFrame_interpolates() {
        Track track = new Track(new SceneElement.OfLight("key"), "intensity",
                List.of(key(10, Interpolation.LINEAR, 1), key(14, Interpolation.LINEAR, 3)));
        Shot shot = Shot.DEFAULT.withTracks(List.of(track));
        assertThat(shot.sceneAt(SCENE, 11.5).light("key").orElseThrow().intensity()).isEqualTo(1.75);
        assertThat(shot.sceneAt(SCENE, 13.75).light("key").orElseThrow().intensity()).isEqualTo(2.875);
    }

    @Test
    void stepped_holdsUntilNextKey() {
        Keyframe[] keys = {key(10, Interpolation.STEPPED, 1), key(12, Interpolation.STEPPED, 3)};
        assertThat(IntStream.rangeClosed(9, 13).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(1, 1, 1, 3, 3);
    }

    @Test
    void smoothBetweenTwoKeys_isFlatAtBothEnds() {
        Keyframe[] keys = {key(0, Interpolation.SMOOTH, 0), key(4, Interpolation.LINEAR, 1)};
        assertThat(IntStream.rangeClosed(0, 4).mapToDouble(f -> intensity(f, keys)).toArray()).containsExactly(0, 0.15625, 0.5, 0.84375, 1);
    }

    @Test
    void smoothThroughCollinearKeys_hasLineSlope() {
        Keyframe[] keys = {key(0, Interpolation.SMOOTH, 0), key(10, Interpolation.SMOOTH, 10), key(20, Interpolation.SMOOTH, 20),
            key(30, Interpolation.SMOOTH, 30)};
        assertThat(IntStream.rangeClosed(10, 20).mapToDouble(f -> intensity(f, keys)).toArray())
                .containsExactly(IntStream.rangeClosed(10, 20).mapToDouble(f -> f).toArray(), org.assertj.core.data.Offset.offset(1e-13));
    }

    @Test
    void direction_followsShorterArc() {
        Track quarter =
                new Track(new SceneElement.OfLight("key"), "direction",
                        List.of(key(0, Interpolation.LINEAR, 1, 0, 0), key(2, Interpolation.LINEAR, 0, 3, 0)));
        Vec3 half = valueAt(1, quarter).light("key").orElseThrow().direction();
        assertThat(half.x()).isCloseTo(Math.sqrt(2), org.assertj.core.data.Offset.offset(1e-15));
        assertThat(half.y()).isCloseTo(Math.sqrt(2), org.assertj.core.data.Offset.offset(1e-15));
    }

    @Test
    void everyTarget_isAnimated() {
        Scene scene = valueAt(5, new Track(SceneElement.CAMERA, "fov", List.of(key(5, Interpolation.LINEAR, 20))),
                new Track(new SceneElement.OfLight("fill"), "on", List.of(word(0, "no"))),
                new Track(new SceneElement.OfLightGroup("desk"), "intensity", List.of(key(5, Interpolation.LINEAR, 0.5))),
                new Track(new SceneElement.OfNode("all"), "at", List.of(key(5, Interpolation.LINEAR, 1, 2, 3))),
                new Track(new SceneElement.OfNode("ball"), "top", List.of(key(5, Interpolation.LINEAR, 0.25))),
                new Track(new SceneElement.OfNode("ball"), "visible", List.of(word(5, "no"))));
        assertThat(scene.camera().fov()).isEqualTo(20);
        assertThat(scene.light("fill").orElseThrow().on()).isFalse();
        assertThat(scene.rig().lightGroup("desk").orElseThrow().intensity()).isEqualTo(0.5);
        assertThat(scene.nodes()).containsExactly(new NodeGroup("all", Placement.IDENTITY.withPosition(new Vec3(1, 2, 3)),
                List.of(((Shape) BALL).withSolid(new Solid.Frustum(0.25, true)).withVisible(false))));
    }

    @Test
    void cameraWithCrossingPaths_isEvaluated() {
        Camera camera = valueAt(5, new Track(SceneElement.CAMERA, "from", List.of(key(5, Interpolation.LINEAR, 0, 0, 0))),
                new Track(SceneElement.CAMERA, "to", List.of(key(5, Interpolation.LINEAR, 0, 0, 10)))).camera();
        assertThat(camera).isEqualTo(new Camera(Vec3.ZERO, new Vec3(0, 0, 10), Vec3.Y, Camera.DEFAULT.fov()));
    }

    @Test
    void lightKeys_shareTheStage() {
        assertThat(valueAt(5, new Track(new SceneElement.OfLight("key"), "angle", List.of(key(5, Interpolation.LINEAR, 12)))).stage())
                .isSameAs(SCENE.stage());
    }

    @Test
    void invalidFrame_isReportedWithNumber() {
        Track through = new Track(new SceneElement.OfNode("ball"), "scale",
                List.of(key(0, Interpolation.LINEAR, 1, 1, 1), key(2, Interpolation.LINEAR, -1, 1, 1)));
        assertThatThrownBy(() -> valueAt(1, through)).isInstanceOf(IllegalArgumentException.class).hasMessage(
                "frame 1: object or group 'ball': scale must be at least 1e-9 in absolute value on every axis, was 0");
        Track blind = new Track(SceneElement.CAMERA, "from", List.of(key(0, Interpolation.LINEAR, 0, 0, 0)));
        assertThatThrownBy(() -> valueAt(7, blind)).hasMessage("frame 7: from and to must be different points");
    }

    @Test
    void unkeyableAttribute_isRejected() {
        assertRejected("there is no light 'rim'",
                new Track(new SceneElement.OfLight("rim"), "intensity", List.of(key(0, Interpolation.LINEAR, 1))));
        assertRejected("has no top", new Track(new SceneElement.OfNode("all"), "top", List.of(key(0, Interpolation.LINEAR, 1))));
        assertRejected("only numbers and words", new Track(new SceneElement.OfLight("key"), "bank", List.of(word(0, "desk"))));
        assertRejected("must be stepped", new Track(new SceneElement.OfLight("key"), "samples", List.of(key(0, Interpolation.LINEAR, 9))));
        assertRejected("intensity must be ≥ 0",
                new Track(new SceneElement.OfLight("key"), "intensity", List.of(key(0, Interpolation.LINEAR, -1))));
        assertRejected("cannot be", new Track(new SceneElement.OfLight("key"), "at", List.of(key(0, Interpolation.LINEAR, 1))));
        assertThatThrownBy(
                () -> new Track(SceneElement.CAMERA, "fov", List.of(key(3, Interpolation.LINEAR, 9), key(3, Interpolation.LINEAR, 9))))
                .hasMessageContaining("found 3 after 3");
        Track once = new Track(SceneElement.CAMERA, "fov", List.of(key(3, Interpolation.LINEAR, 9)));
        assertThatThrownBy(() -> Shot.DEFAULT.withTracks(List.of(once, once))).hasMessageContaining("once");
    }

    private static void assertRejected(String sentence, Track track) {
        assertThatThrownBy(() -> track.check(SCENE)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining(sentence);
    }

    @Property
    void keyFrame_hasExactKeyValue(@ForAll("cases") Case c) {
        for (Track track : c.shot.tracks()) {
            SceneAttribute<?, ?> attribute = attribute(c.scene, track);
            for (Keyframe key : track.keys()) {
                assertThat(value(attribute.kind(), track, key.frame())).isEqualTo(key.value());
            }
        }
    }

    @Property
    void betweenKeys_valueStaysInRange(@ForAll("cases") Case c, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        for (Track track : c.shot.tracks()) {
            SceneAttribute<?, ?> attribute = attribute(c.scene, track);
            Keyframe before = track.keys().stream().filter(k -> k.frame() <= frame).reduce((_, b) -> b).orElse(track.keys().getFirst());
            Keyframe after = track.keys().stream().filter(k -> k.frame() >= frame).findFirst().orElse(track.keys().getLast());
            if (!(attribute.kind() instanceof NumericKind<?> q && q.form() == NumericKind.Form.DIRECTION)
                    && value(attribute.kind(), track, frame) instanceof KeyframeValue.Numbers(List<Double> all)) {
                for (int i = 0; i < all.size(); i++) {
                    double a = ((KeyframeValue.Numbers) before.value()).values().get(i);
                    double b = ((KeyframeValue.Numbers) after.value()).values().get(i);
                    assertThat(all.get(i)).isBetween(Math.min(a, b), Math.max(a, b));
                }
            }
        }
    }

    @Property
    void unkeyedAttribute_isUnchanged(@ForAll("cases") Case c, @ForAll @IntRange(max = ShotArbitraries.LAST) int frame) {
        Scene scene;
        try {
            scene = c.shot.sceneAt(c.scene, frame);
        } catch (IllegalArgumentException e) {
            Assume.that(false);
            return;
        }
        for (Light light : c.scene.lights()) {
            for (LightAttribute<?> attribute : LightAttribute.ALL) {
                if (c.shot.track(new SceneElement.OfLight(light.name()), attribute.name()).isEmpty()) {
                    assertThat(attribute.get(scene.light(light.name()).orElseThrow())).isEqualTo(attribute.get(light));
                }
            }
        }
        assertThat(settings(scene)).isEqualTo(settings(c.scene));
    }

    /** Returns the materials without what bulbs derive from lights, which may be keyed. */
    private static List<Material> settings(Scene scene) {
        return scene.materials().stream().map(m -> m.withBulb(m.bulb().withGlow(Rgb.BLACK).withUnit(Rgb.BLACK))).toList();
    }

    @Property
    void smooth_isMonotonicWithContinuousSlope(@ForAll @DoubleRange(min = -8, max = 8) double a,
            @ForAll @DoubleRange(min = -8, max = 8) double b,
            @ForAll @DoubleRange(min = -8, max = 8) double c, @ForAll @DoubleRange(min = -8, max = 8) double d,
            @ForAll @IntRange(min = 1, max = 100) int h, @ForAll @IntRange(min = 1, max = 100) int k,
            @ForAll @IntRange(min = 1, max = 100) int l) {
        double atB = KeyframeInterpolator.slope(a, b, c, h, k);
        double atC = KeyframeInterpolator.slope(b, c, d, k, l);
        double last = b;
        for (int i = 1; i <= 64; i++) {
            double v = KeyframeInterpolator.cubic(b, c, atB, atC, k, i / 64.0);
            assertThat((v - last) * Math.signum(c - b)).isGreaterThanOrEqualTo(-4 * Math.ulp(8.0));
            last = v;
        }
        // A difference over a small interval approximates the derivative, which must equal the slope at the keyframe on both sides.
        double e = 0x1p-20;
        double before = (b - KeyframeInterpolator.cubic(a, b, 0, atB, h, 1 - e)) / (e * h);
        double after = (KeyframeInterpolator.cubic(b, c, atB, atC, k, e) - b) / (e * k);
        assertThat(before).isCloseTo(atB, org.assertj.core.data.Offset.offset(1e-3));
        assertThat(after).isCloseTo(atB, org.assertj.core.data.Offset.offset(1e-3));
    }

    @Property
    void smoothOfHugeValues_isFinite(@ForAll @DoubleRange(max = 1e30) double a, @ForAll @IntRange(min = -320, max = 30) int power,
            @ForAll @DoubleRange(max = 1) double t) {
        double b = Math.pow(10, power);
        assertThat(KeyframeInterpolator.cubic(a, b, KeyframeInterpolator.slope(0, a, b, 1, 9),
                KeyframeInterpolator.slope(a, b, 1e30, 9, 1e9), 9, t)).isFinite();
    }

    @Provide
    Arbitrary<ValueKind<?>> kinds() {
        return Arbitraries.of(LightAttribute.ALL).map(SceneAttribute::kind);
    }

    @Property
    void onlyNumbersAndWords_areKeyable(@ForAll("kinds") ValueKind<?> kind) {
        assertThat(kind.keyframeSupport() == KeyframeSupport.NONE)
                .isEqualTo(!(kind instanceof NumericKind<?> || kind instanceof ChoiceKind<?>));
    }

    private static SceneAttribute<?, ?> attribute(Scene scene, Track track) {
        return track.target().attributes(scene).stream().filter(a -> a.name().equals(track.attribute())).findFirst().orElseThrow();
    }

    private static <V> KeyframeValue value(ValueKind<V> kind, Track track, int frame) {
        V value = track.evaluate(frame, kind);
        return switch (kind) {
            case NumericKind<V> q -> new KeyframeValue.Numbers(q.components().apply(value));
            case ChoiceKind<V> w -> new KeyframeValue.Word(w.format(value));
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.TextureKind _ ->
                    throw new AssertionError();
        };
    }
}
