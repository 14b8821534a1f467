package lightning.document.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCameraTest;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Conversion of a light's recorded shot to keyframes of another shot, and back. */
class RecordedShotTest {
    private static final Light LIGHT = Light.of("key", LightType.SPOT);
    private static final Scene SCENE =
            new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(), List.of(LIGHT));

    /** Light at keyframes with a constant interval. */
    record Case(int interval, List<Light> samples) {
        RecordedShot shot() {
            return RecordedShot.of(interval, samples);
        }
    }

    @Provide
    Arbitrary<Case> cases() {
        Arbitrary<Double> coordinate = Arbitraries.doubles().between(-1e6, 1e6);
        Arbitrary<Vec3> points = Combinators.combine(coordinate, coordinate, coordinate).as(Vec3::new);
        Arbitrary<Light> lights = Combinators.combine(points, points.filter(v -> v.maxAbs() > 1e-6))
                .as((at, to) -> LIGHT.withPosition(at).withDirection(to));
        return Combinators.combine(Arbitraries.integers().between(1, 10000), lights.list().ofMinSize(1).ofMaxSize(20)).as(Case::new);
    }

    private static Light light(double x) {
        return LIGHT.withPosition(new Vec3(x, 0, 0));
    }

    private static Light lightAt(Shot shot, double frame) {
        return shot.sceneAt(SCENE, frame).light("key").orElseThrow();
    }

    @Test
    void recorder_recordsEveryTenthFrame() {
        var recorder = new MotionRecorder(RecordedShot.DEFAULT_INTERVAL);
        for (int frame = 0; frame <= 25; frame++) {
            recorder.recordFrame(light(frame));
        }
        assertThat(recorder.recordedShot()).contains(RecordedShot.of(10, List.of(light(0), light(10), light(20))));
        assertThat(recorder.frameCount()).isEqualTo(26);
    }

    @Test
    void recorderBeforeTheFirstFrame_hasNoShot() {
        assertThat(new MotionRecorder(1).recordedShot()).isEmpty();
    }

    @Test
    void keys_areInPositionAndDirectionTracks() {
        RecordedShot recorded = RecordedShot.of(10, List.of(light(1), light(2)));
        assertThat(recorded.shot().tracks()).containsExactly(
                new Track(new SceneElement.OfLight("key"), "at", List.of(key(0, 1, 0, 0), key(10, 2, 0, 0))),
                new Track(new SceneElement.OfLight("key"), "direction", List.of(key(0, 0, -1, 0), key(10, 0, -1, 0))));
    }

    private static Keyframe key(int frame, double x, double y, double z) {
        return new Keyframe(frame, new KeyframeValue.Numbers(List.of(x, y, z)), Interpolation.LINEAR);
    }

    @Test
    void shot_endsAtItsLastKey() {
        assertThat(RecordedShot.of(10, List.of(light(0), light(1), light(2))).frameCount()).isEqualTo(21);
        assertThat(RecordedShot.of(10, List.of(light(0))).frameCount()).isEqualTo(1);
    }

    @Test
    void betweenKeys_lightMovesLinearlyAndRotatesEvenly() {
        RecordedShot recorded = RecordedShot.of(10, List.of(LIGHT.withDirection(new Vec3(1, 0, 0)),
                LIGHT.withPosition(new Vec3(4, 2, 0)).withDirection(new Vec3(0, 0, 3))));
        Light half = lightAt(recorded.shot(), 5);
        assertThat(half.position()).isEqualTo(new Vec3(2, 1, 0));
        PreviewCameraTest.assertClose(half.direction(), new Vec3(Math.sqrt(2), 0, Math.sqrt(2)), 1e-12);
    }

    @Test
    void oppositeDirections_rotateThroughValidDirection() {
        RecordedShot recorded =
                RecordedShot.of(1, List.of(LIGHT.withDirection(new Vec3(0, 1, 0)), LIGHT.withDirection(new Vec3(0, -1, 0))));
        Vec3 half = lightAt(recorded.shot(), 0.5).direction();
        assertThat(half.length()).isCloseTo(1, within(1e-12));
        assertThat(half.y()).isCloseTo(0, within(1e-12));
    }

    @Test
    void outsideShot_lightIsAtEnds() {
        RecordedShot recorded = RecordedShot.of(10, List.of(light(1), light(2)));
        assertThat(lightAt(recorded.shot(), -5).position().x()).isEqualTo(1);
        assertThat(lightAt(recorded.shot(), 99).position().x()).isEqualTo(2);
    }

    @Property
    void atKeys_lightEqualsKeyExactly(@ForAll("cases") Case c) {
        for (int i = 0; i < c.samples.size(); i++) {
            assertThat(lightAt(c.shot().shot(), (double) i * c.interval)).isEqualTo(c.samples.get(i));
        }
    }

    @Property
    void everyFrame_isAValidLight(@ForAll("cases") Case c) {
        RecordedShot recorded = c.shot();
        for (int i = 0; i <= 50; i++) {
            Light there = lightAt(recorded.shot(), recorded.frameCount() * i / 50.0);
            assertThat(there.withPosition(LIGHT.position()).withDirection(LIGHT.direction())).isEqualTo(LIGHT);
        }
    }

    @Property
    void addToShotAndExtract_isEqual(@ForAll("cases") Case c, @ForAll @IntRange(max = 99) int first) {
        Shot shot = c.shot().addTo(Shot.DEFAULT, first);
        RecordedShot expected = c.samples.size() > 1 ? c.shot() : RecordedShot.of(RecordedShot.DEFAULT_INTERVAL, c.samples);
        assertThat(RecordedShot.of(shot, "key")).contains(expected);
    }

    @Property
    void lightAtEveryFrame_isWhereItWasRecordedInEveryBit(@ForAll("cases") Case c, @ForAll @IntRange(max = 99) int first,
            @ForAll @IntRange(min = 1, max = 20) int every) {
        RecordedShot recorded = RecordedShot.of(every, c.samples);
        Shot shot = recorded.addTo(Shot.DEFAULT, first);
        shot.check(SCENE);
        for (int frame = -1; frame <= recorded.frameCount(); frame++) {
            assertThat(lightAt(shot, first + frame)).isEqualTo(lightAt(recorded.shot(), frame));
        }
    }

    @Test
    void addToShot_replacesKeysAndKeepsFrames() {
        RecordedShot recorded = RecordedShot.of(10, List.of(light(1), light(2)));
        Track intensity =
                new Track(new SceneElement.OfLight("key"), "intensity",
                        List.of(new Keyframe(3, new KeyframeValue.Numbers(List.of(2.0)), Interpolation.LINEAR)));
        Shot shot = recorded.addTo(new Shot(1, 12, 24, List.of(intensity)), 5);
        assertThat(shot.first()).isEqualTo(1);
        assertThat(shot.last()).isEqualTo(15);
        assertThat(shot.tracks()).contains(intensity).hasSize(3);
        assertThat(recorded.addTo(shot, 0).track(new SceneElement.OfLight("key"), "at").orElseThrow().keys())
                .containsExactly(key(0, 1, 0, 0), key(10, 2, 0, 0));
        assertThatThrownBy(() -> recorded.addTo(shot, Shot.MAX_FRAME))
                .hasMessage("the frame of a key must be from 0 to 1e9, was 1.00000001e9");
    }

    @Test
    void unevenKeys_giveEmpty() {
        Shot shot = RecordedShot.of(5, List.of(LIGHT, LIGHT, LIGHT)).addTo(Shot.DEFAULT, 1);
        assertThat(RecordedShot.of(shot, "key")).isPresent();
        assertThat(RecordedShot.of(shot, "fill")).isEmpty();
        assertNone(shot, new Keyframe(11, key(11, 0, 0, 0).value(), Interpolation.SMOOTH));
        assertNone(shot, key(12, 0, 0, 0));
        assertNone(shot, key(16, 0, 0, 0));
        assertThat(RecordedShot.of(shot.withTracks(shot.tracks().subList(0, 1)), "key")).isEmpty();
        assertThat(RecordedShot.of(RecordedShot.of(1, List.of(LIGHT)).addTo(Shot.DEFAULT, 0)
                .with(new Track(new SceneElement.OfLight("key"), "at", List.of(key(0, 0, 0, 0), key(10_001, 0, 0, 0))))
                .with(new Track(new SceneElement.OfLight("key"), "direction", List.of(key(0, 0, 1, 0), key(10_001, 0, 1, 0)))), "key"))
                .isEmpty();
    }

    private static void assertNone(Shot shot, Keyframe other) {
        assertThat(RecordedShot.of(shot.with(shot.tracks().getFirst().with(other)), "key")).isEmpty();
    }
}
