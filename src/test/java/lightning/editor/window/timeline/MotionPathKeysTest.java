package lightning.editor.window.timeline;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.Slider;
import lightning.base.math.Vec3;
import lightning.editor.document.Command;
import lightning.editor.document.OpenDocument;
import lightning.editor.window.EditorFixture;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;
import org.junit.jupiter.api.Test;

/** Converts a light's motion path to keyframes of the shot, and back. */
class MotionPathKeysTest extends EditorFixture {
    private static final String SHOT = """
            shot {
              frames 1 21
              light stage {
                at { 1 0 2 0  11 1 2 0  21 1 3 0 }
                direction { 1 0 -1 0  11 0 -1 0  21 1 -1 0 }
              }
            }
            """;

    private List<Keyframe> keys(String attribute) {
        return model().editor().document().content().shot().orElseThrow().track(TrackTarget.light("stage"), attribute).map(Track::keys)
                .orElse(List.of());
    }

    @Test
    void keys_convertedToPathAndBack_moveToOtherFrame() throws Exception {
        var file = folder.resolve("desk.jen");
        Files.writeString(file, Files.readString(file) + SHOT);
        OpenDocument opened = OpenDocument.open(file);
        robot.interact(() -> {
            model().open(opened);
            model().editor().selection().selectLight("stage");
            model().editor().showFrame(5);
        });
        waitForPicture();
        List<Keyframe> before = keys("at");
        robot.interact(() -> model().commands().run(Command.KEYS_TO_WAY));
        assertThat(model().editor().isAnimating()).isTrue();
        robot.interact(() -> robot.lookup("#scrub").<Slider>query().setValue(15));
        assertThat(light("stage").position()).isEqualTo(new Vec3(1, 2.5, 0));
        assertThat(isEnabled(Command.WAY_TO_KEYS)).isTrue();
        click("way-to-keys");
        assertThat(model().editor().isAnimating()).isFalse();
        Stream.of("at", "direction").forEach(a -> assertThat(keys(a).stream().map(Keyframe::frame)).containsExactly(5, 15, 25));
        assertThat(keys("at").stream().map(Keyframe::value).toList()).isEqualTo(before.stream().map(Keyframe::value).toList());
        assertThat(model().editor().document().shotFrame().orElseThrow().shot().last()).isEqualTo(25);
        robot.interact(() -> model().commands().run(Command.UNDO));
        assertThat(keys("at")).isEqualTo(before);
    }
}
