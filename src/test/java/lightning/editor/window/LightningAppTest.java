package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javafx.collections.ListChangeListener;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.text.Text;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.editor.window.widget.PictureView;
import lightning.sample.Slow;
import lightning.scene.AntialiasMode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import org.testfx.framework.junit5.ApplicationExtension;
import org.testfx.framework.junit5.Start;
import org.testfx.framework.junit5.Stop;

@ExtendWith({JavaFxRequirement.class, ApplicationExtension.class})
@Slow
class LightningAppTest {
    private final LightningApp app = new LightningApp() {
        @Override
        long previewTimeoutMs() {
            return TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS);
        }

        @Override
        void editorOpened(Editor opened) {
            editor = opened;
        }
    };
    private volatile Editor editor;
    private Stage stage;
    private String first;
    private String firstTitle;
    /** True if the picture was in a window when it was first drawn; empty before that. */
    private Optional<Boolean> seen = Optional.empty();
    private final List<String> notes = new ArrayList<>();

    @Start
    private void start(Stage primary) throws Exception {
        stage = primary;
        app.init();
        app.start(primary);
        first = primary.getScene().getRoot().getId();
        firstTitle = primary.getTitle();
        var picture = (PictureView) primary.getScene().lookup("#traced-picture");
        // The picture is not part of the window while its pane is being created.
        picture.emptyProperty().subscribe(empty -> seen = empty ? seen : Optional.of(picture.getScene() != null));
        picture.getChildrenUnmodifiable().addListener((ListChangeListener<Node>) _ -> notes.addAll(texts(picture)));
    }

    /** Returns the notes drawn over the picture. */
    private static List<String> texts(PictureView picture) {
        return picture.lookupAll("#first-words Text").stream().map(text -> ((Text) text).getText()).toList();
    }

    @Stop
    private void stop() {
        app.stop();
    }

    /** The window and its panes open while a large scene is still being read. */
    @Test
    void window_opensBeforeScene(FxRobot robot) throws Exception {
        assertThat(first).isEqualTo("opening");
        TestEditors.awaitNode(robot, "#editor");
        assertThat(stage.getScene().getRoot().getId()).isEqualTo("editor");
    }

    @Test
    void picture_isShownBeforePanes(FxRobot robot) throws Exception {
        TestEditors.awaitNode(robot, "#editor");
        assertThat(seen).contains(true);
    }

    @Test
    void picture_beforePanes_isLabeledCoarse(FxRobot robot) throws Exception {
        TestEditors.awaitNode(robot, "#editor");
        assertThat(notes).containsExactly("Refining…");
        assertThat(TestEditors.inWindowThread(() -> texts(robot.lookup("#traced-picture").query()))).isEmpty();
    }

    @Test
    void panes_whileLoading_showLoading(FxRobot robot) throws Exception {
        TestEditors.awaitNode(robot, "#editor");
        // The app still creates panels in its own window while it is idle.
        Stage other = TestEditors.inWindowThread(() -> {
            var window = new Stage();
            window.setScene(new Scene(TestEditors.layout(Path.of("scenes/large.jen"))));
            window.show();
            return window;
        });
        FastRobot.settle();
        assertThat(robot.lookup(n -> n instanceof Label l && l.getText().equals("Reading large.jen …")).queryAll()).hasSize(3);
        robot.interact(other::close);
    }

    @Test
    void window_hasBothCanvasesAndSidePanels(FxRobot robot) throws Exception {
        assertThat(stage.isShowing()).isTrue();
        TestEditors.awaitNode(robot, "#editor");
        FastRobot.settle();
        for (String pane : new String[] {"#traced", "#preview", "#lights", "#properties"}) {
            assertThat(robot.lookup(pane).tryQuery()).as(pane).isPresent();
        }
    }

    @Test
    void withoutFile_opensCopyAtSizeOfPaneWithLive(FxRobot robot) throws Exception {
        TestEditors.await(() -> editor != null);
        TestEditors.awaitNode(robot, "#traced-picture");
        FastRobot.settle();
        var model = editor.model();
        var picture = (PictureView) robot.lookup("#traced-picture").query();
        assertThat(stage.getTitle()).isEqualTo("Copy of stage.jen – Lightning");
        assertThat(model.editor().document().isDirty()).isFalse();
        assertThat(model.editor().liveProperty().get()).isTrue();
        assertThat(model.editor().scene().picture()).isEqualTo(picture.area().fit(model.editor().scene().picture()));
        assertThat(model.editor().scene().picture().sampling().antialias()).isEqualTo(AntialiasMode.EDGES);
    }

    @Test
    void welcomePage_leavesPartOfStartScene_andEscapeClosesIt(FxRobot robot) throws Exception {
        TestEditors.awaitNode(robot, "#welcome");
        TestEditors.awaitNode(robot, "#traced-picture");
        FastRobot.settle();
        assertThat(robot.lookup("#welcome").query().localToScene(0, 0).getX()).isGreaterThan(0.4 * stage.getScene().getWidth());
        assertThat(stage.getScene().getFocusOwner().getId()).isEqualTo("welcome-open");
        robot.interact(() -> stage.getScene().getFocusOwner().fireEvent(
                new KeyEvent(KeyEvent.KEY_PRESSED, "", "", KeyCode.ESCAPE, false, false, false, false)));
        FastRobot.settle();
        assertThat(robot.lookup("#welcome").tryQuery()).isEmpty();
        assertThat(stage.getScene().getFocusOwner().getId()).isEqualTo("preview-canvas");
    }

    /** The window may live on, as with the next test's app, so the editor must not open in it. */
    @Test
    void stoppedWhileOpening_opensNoEditor(FxRobot robot) throws Exception {
        FxToolkit.setupFixture(app::stop);
        var next = new AtomicReference<Editor>();
        var nextApp = new LightningApp() {
            @Override
            void editorOpened(Editor opened) {
                next.set(opened);
            }
        };
        nextApp.init();
        FxToolkit.setupFixture(() -> nextApp.start(stage));
        TestEditors.await(() -> next.get() != null);
        FastRobot.settle();
        FxToolkit.setupFixture(nextApp::stop);
        assertThat(editor).isNull();
    }

    @Test
    void title_isSetBeforeTheFirstFrame() {
        assertThat(firstTitle).isEqualTo("Lightning");
    }
}
