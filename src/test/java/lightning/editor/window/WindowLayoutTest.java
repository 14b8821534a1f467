package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import lightning.editor.Command;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.widget.PictureView;
import lightning.format.jen.JenReader;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import org.junit.jupiter.api.Test;

/** The pictures have the sizes that the layout commands give them. */
@OwnEditor
class WindowLayoutTest extends EditorFixture {
    private boolean isVisible(String query) {
        return robot.lookup(query).tryQuery().isPresent();
    }

    private PictureView picture() {
        return robot.lookup("#traced-picture").query();
    }

    private void arrange(CanvasLayout canvases) {
        robot.interact(() -> model().layout().canvasLayoutProperty().set(canvases));
    }

    @Test
    void pictureAlone_fillsBothCanvases() {
        arrange(CanvasLayout.SIDE_BY_SIDE);
        double half = picture().getWidth();
        arrange(CanvasLayout.PICTURE_ALONE);
        assertThat(isVisible("#preview-canvas")).isFalse();
        assertThat(picture().getWidth()).isGreaterThan(1.9 * half);
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        arrange(CanvasLayout.SIDE_BY_SIDE);
        assertThat(isVisible("#preview-canvas")).isTrue();
        assertThat(picture().getWidth()).isBetween(half - 2, half + 2);
    }

    @Test
    void initialPicture_takesMostOfTheWindow() {
        arrange(new WindowLayout().canvasLayoutProperty().get());
        FastRobot.settle();
        assertThat(picture().getWidth()).isGreaterThan(0.6 * stage.getScene().getWidth());
    }

    @Test
    void previewAlone_canBeEdited() {
        arrange(CanvasLayout.PREVIEW_ALONE);
        assertThat(isVisible("#traced-picture")).isFalse();
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.CLOSE_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("sun");
    }

    @Test
    void largePicture_leavesOtherSmall() {
        arrange(CanvasLayout.PICTURE_LARGE);
        assertThat(picture().getWidth()).isGreaterThan(2 * preview().getWidth());
    }

    @Test
    void largePicture_hasPreviewAsInset() {
        arrange(CanvasLayout.PICTURE_LARGE);
        FastRobot.settle();
        assertThat(ScreenBounds.of(picture()).contains(ScreenBounds.of(preview())))
                .isTrue();
        assertThat(preview().getWidth() / preview().getHeight()).isBetween(1.3, 1.37);
        arrange(CanvasLayout.SIDE_BY_SIDE);
        FastRobot.settle();
        assertThat(preview().getWidth()).isGreaterThan(0.8 * picture().getWidth());
        assertThat(isVisible("#preview-size")).isTrue();
    }

    @Test
    void tabOverPicture_togglesPanels() {
        double before = picture().getWidth();
        robot.interact(() -> preview().requestFocus());
        robot.moveTo("#traced-picture");
        robot.push(KeyCode.TAB);
        assertThat(isVisible("#lights")).isFalse();
        assertThat(isShown("toolbar")).isFalse();
        assertThat(picture().getWidth()).isGreaterThan(before + 50);
        robot.push(KeyCode.TAB);
        assertThat(isVisible("#lights")).isTrue();
        assertThat(isShown("toolbar")).isTrue();
    }

    @Test
    void tabOverPicture_afterClickInToolBarOrList_togglesPanels() {
        for (String clicked : new String[] {"live", "lights"}) {
            click(clicked);
            robot.moveTo("#traced-picture");
            robot.push(KeyCode.TAB);
            assertThat(isVisible("#lights")).as(clicked).isFalse();
            robot.push(KeyCode.TAB);
            assertThat(isVisible("#lights")).as(clicked).isTrue();
        }
    }

    private void showTimeline(boolean shown) {
        robot.interact(() -> model().layout().timelineShownProperty().set(shown));
        FastRobot.settle();
    }

    private SplitPane picturesAndDocks() {
        return (SplitPane) robot.lookup("#dock-below").query().getParent().getParent();
    }

    private double timeline() {
        return robot.lookup("#timeline").<Region>query().getHeight();
    }

    @Test
    void timeline_shownFirst_leavesMostOfTheHeight() {
        showTimeline(true);
        assertThat(timeline()).isGreaterThan(198).isLessThan(0.5 * picturesAndDocks().getHeight());
    }

    @Test
    void timeline_shownAgain_keepsHeight() {
        showTimeline(true);
        robot.interact(() -> picturesAndDocks().setDividerPositions(0.6));
        FastRobot.settle();
        double left = timeline();
        showTimeline(false);
        showTimeline(true);
        assertThat(timeline()).isBetween(left - 1, left + 1);
    }

    @Test
    void tabInField_focusesNextField() {
        robot.interact(() -> robot.lookup("#intensity .number-field").<TextField>query().requestFocus());
        robot.moveTo("#traced-picture");
        robot.push(KeyCode.TAB);
        assertThat(isVisible("#lights")).isTrue();
    }

    @Test
    void arrangement_afterRestart_isRestoredButHiddenPanelsAreNot() {
        arrange(CanvasLayout.PREVIEW_LARGE);
        robot.interact(() -> model().commands().run(Command.HIDE_PANELS));
        waitFor("the preferences are written", () -> Files.exists(folder.resolve("own/preferences.properties")));
        waitFor("the preference is saved",
                () -> new Preferences(folder.resolve("own"), Runnable::run).hasValue("arrangement", "PREVIEW_LARGE"));
    }

    @Test
    void newScene_isUntitledFitsPaneAndSavePromptsForFile() throws Exception {
        robot.interact(() -> model().commands().run(Command.NEW_SCENE));
        waitFor("the scene is open", () -> model().editor().document().isUntitled());
        robot.interact(() -> model().commands().run(Command.CANCEL));
        var opened = model().editor().scene();
        double scale = stage.getOutputScaleX();
        assertThat((double) opened.picture().width()).isBetween(picture().getWidth() * scale - 2, picture().getWidth() * scale);
        assertThat(opened.picture().sampling().antialias()).isEqualTo(AntialiasMode.EDGES);
        assertThat(model().editor().document().isDirty()).isFalse();
        assertThat(new Preferences(folder.resolve("own"), Runnable::run).recent()).doesNotContain(model().editor().document().file());
        answer = folder.resolve("fresh");
        robot.interact(() -> model().commands().run(Command.SAVE_SCENE));
        waitFor("the scene is saved", () -> model().editor().document().name().equals("fresh.jen"));
        assertThat(model().editor().document().isUntitled()).isFalse();
        assertThat(JenReader.read(folder.resolve("fresh.jen")).scene()).isEqualTo(opened);
    }
}
