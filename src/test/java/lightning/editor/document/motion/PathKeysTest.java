package lightning.editor.document.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.Picture;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** A recorded way as keys, and back. */
class PathKeysTest {
    private static final Scene SCENE = new Scene(Picture.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(), List.of(),
            List.of(Light.of("key", LightType.SPOT)));

    @Provide
    Arbitrary<MotionPath> paths() {
        Arbitrary<Vec3> vectors = Arbitraries.doubles().between(-9, 9).list().ofSize(3).map(n -> new Vec3(n.get(0), n.get(1), n.get(2)));
        Arbitrary<MotionPath.Key> keys = Combinators.combine(vectors, vectors.filter(v -> v.maxAbs() > 1e-6)).as(MotionPath.Key::new);
        return Combinators.combine(Arbitraries.integers().between(1, 20), keys.list().ofMinSize(1).ofMaxSize(6)).as(MotionPath::new);
    }

    @Property
    void wayAsKeysAndBack_isTheSameWay(@ForAll("paths") MotionPath path, @ForAll @IntRange(max = 99) int first) {
        Shot shot = PathKeys.of(Shot.DEFAULT, "key", path, first);
        MotionPath expected = path.keys().size() > 1 ? path : new MotionPath(MotionPath.DEFAULT_EVERY, path.keys());
        assertThat(PathKeys.path(shot, "key")).contains(expected);
    }

    @Property
    void lightAtEveryFrame_isWhereTheWayHasItInEveryBit(@ForAll("paths") MotionPath path, @ForAll @IntRange(max = 99) int first) {
        Shot shot = PathKeys.of(Shot.DEFAULT, "key", path, first);
        shot.check(SCENE);
        for (int frame = -1; frame <= path.frames(); frame++) {
            assertThat(shot.at(SCENE, first + frame).light("key")).contains(path.at(SCENE.lights().getFirst(), frame));
        }
    }

    @Test
    void keysThatAreNoWay_giveNone() {
        Shot shot = PathKeys.of(Shot.DEFAULT, "key", new MotionPath(5, List.of(new MotionPath.Key(Vec3.ZERO, Vec3.Y))), 1);
        assertThat(PathKeys.path(shot, "fill")).isEmpty();
        Track smooth = new Track(Target.light("key"), "at",
                List.of(new Key(1, new Setting.Numbers(List.of(0.0, 0.0, 0.0)), Passage.SMOOTH)));
        assertThat(PathKeys.path(shot.with(smooth), "key")).isEmpty();
    }
}
