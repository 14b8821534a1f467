package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import lightning.base.work.Wait;
import lightning.editor.window.widget.PictureView;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.ApplicationExtension;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxNeeds.class, ApplicationExtension.class})
@Slow
class LightningAppTest {
    private final LightningApp app = new LightningApp() {
        @Override
        long patience() {
            return TimeUnit.SECONDS.toMillis(Wait.MOST_SECONDS);
        }
    };
    private Stage stage;
    private String first;
    /** Whether the picture came into the window; empty before it came at all. */
    private Optional<Boolean> seen = Optional.empty();
    private final List<String> said = new ArrayList<>();

    @Start
    private void start(Stage primary) throws Exception {
        stage = primary;
        app.init();
        app.start(primary);
        first = primary.getScene().getRoot().getId();
        var picture = (PictureView) primary.getScene().lookup("#traced-picture");
        // A pane takes it out of the window until it is made.
        picture.emptyProperty().subscribe(empty -> seen = empty ? seen : Optional.of(picture.getScene() != null));
        picture.getChildrenUnmodifiable().addListener((ListChangeListener<Node>) _ -> said.addAll(words(picture)));
    }

    /** What the picture says by itself. */
    private static List<String> words(PictureView picture) {
        return picture.lookupAll("#first-words Text").stream().map(text -> ((Text) text).getText()).toList();
    }

    @Stop
    private void stop() {
        app.stop();
    }

    /** A large scene is read for a while, and the window is there before, with its panes. */
    @Test
    void window_isThereBeforeItsScene(FxRobot robot) throws Exception {
        assertThat(first).isEqualTo("opening");
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        assertThat(stage.getScene().getRoot().getId()).isEqualTo("editor");
    }

    @Test
    void picture_isThereBeforeThePanes(FxRobot robot) throws Exception {
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        assertThat(seen).contains(true);
    }

    @Test
    void pictureBeforeThePanes_saysThatItIsCoarse(FxRobot robot) throws Exception {
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        assertThat(said).containsExactly("Coarse picture, a finer one follows");
        assertThat(words(robot.lookup("#traced-picture").query())).isEmpty();
    }

    @Test
    void panesOfASceneThatIsRead_saySo(FxRobot robot) throws Exception {
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        robot.interact(() -> stage.getScene().setRoot(OpenEditor.frame(Path.of("scenes/large.jen"))));
        QuickRobot.settle();
        assertThat(robot.lookup(n -> n instanceof Label l && l.getText().equals("Reading large.jen …")).queryAll()).hasSize(3);
    }

    @Test
    void window_hasBothCanvasesAndWhatStandsBesideThem(FxRobot robot) throws Exception {
        assertThat(stage.isShowing()).isTrue();
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        QuickRobot.settle();
        for (String pane : new String[] {"#traced", "#preview", "#lights", "#properties"}) {
            assertThat(robot.lookup(pane).tryQuery()).as(pane).isPresent();
        }
    }

    @Test
    void preview_takesTheKeysAtOnce(FxRobot robot) throws Exception {
        OpenEditor.await(() -> robot.lookup("#editor").tryQuery().isPresent());
        QuickRobot.settle();
        assertThat(stage.getScene().getFocusOwner().getId()).isEqualTo("preview-canvas");
    }
}
