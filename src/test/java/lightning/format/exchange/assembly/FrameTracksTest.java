package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import lightning.sample.StudioScene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightType;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Keyframes of values that are known at every frame. */
class FrameTracksTest {
    private static final int FRAMES = 100_000;
    private static final Light LAMP = Light.of("lamp", LightType.POINT);

    private static List<Track> tracks(int frames, IntToDoubleFunction intensity) {
        return new FrameTracks(0).of(new SceneElement.OfLight("lamp"), LightAttribute.ALL,
                IntStream.range(0, frames).mapToObj(frame -> LAMP.withIntensity(intensity.applyAsDouble(frame))).toList());
    }

    /** Comparing each frame with all before would take minutes. */
    @Test
    @Timeout(value = 20, unit = TimeUnit.SECONDS)
    void straightLineOfManyFrames_hasTwoKeys() {
        List<Track> tracks = tracks(FRAMES, frame -> 5 + frame);
        assertThat(tracks).hasSize(1);
        assertThat(tracks.getFirst().keys()).extracting(Keyframe::frame).containsExactly(0, FRAMES - 1);
    }

    /** Values that hold for long, jump, rise and fall, each for longer than what is compared at a time. */
    @Test
    void keys_giveTheValueOfEachFrame() {
        IntToDoubleFunction intensity = frame -> frame < 700 ? 2 : frame < 1000 ? 2 + 0.5 * (frame - 700) : frame < 1001 ? 90 : 7;
        var animated =
                new AnimatedScene(StudioScene.of(LightType.POINT).withLights(List.of(LAMP)),
                        Optional.of(new Shot(0, 1999, 24, tracks(2000, intensity))));
        assertThat(animated.shot().orElseThrow().tracks().getFirst().keys()).hasSize(5);
        for (int frame = 0; frame < 2000; frame++) {
            assertThat(animated.sceneAt(frame).lights().getFirst().intensity()).as("frame %d", frame)
                    .isCloseTo(intensity.applyAsDouble(frame), offset(1e-3));
        }
    }
}
