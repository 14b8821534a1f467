package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.util.List;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Region;
import lightning.editor.document.Command;
import lightning.editor.window.model.Arrangement.Canvases;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.widget.PictureView;
import lightning.format.jen.JenReader;
import lightning.render.shading.ReferenceTracer;
import lightning.scene.Antialias;
import org.junit.jupiter.api.Test;

/** The pictures have the room that the artist gives them. */
class ArrangementTest extends EditorDesk {
    private boolean isThere(String query) {
        return robot.lookup(query).tryQuery().isPresent();
    }

    private PictureView picture() {
        return robot.lookup("#traced-picture").query();
    }

    private void arrange(Canvases how) {
        robot.interact(() -> model().arrangement().canvasesProperty().set(how));
    }

    @Test
    void pictureAlone_hasTheRoomOfBoth() {
        double half = picture().getWidth();
        arrange(Canvases.PICTURE_ALONE);
        assertThat(isThere("#preview-canvas")).isFalse();
        assertThat(picture().getWidth()).isGreaterThan(1.9 * half);
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
        arrange(Canvases.SIDE_BY_SIDE);
        assertThat(isThere("#preview-canvas")).isTrue();
        assertThat(picture().getWidth()).isBetween(half - 2, half + 2);
    }

    @Test
    void previewAlone_isEditedAsBefore() {
        arrange(Canvases.PREVIEW_ALONE);
        assertThat(isThere("#traced-picture")).isFalse();
        robot.interact(() -> preview().requestFocus());
        robot.push(KeyCode.CLOSE_BRACKET);
        assertThat(model().editor().selection().light().name()).isEqualTo("sun");
    }

    @Test
    void onePictureLarge_leavesTheOtherSmall() {
        arrange(Canvases.PICTURE_LARGE);
        assertThat(picture().getWidth()).isGreaterThan(2 * preview().getWidth());
    }

    @Test
    void tabOverAPicture_hidesThePanelsAndBringsThemBack() {
        double before = picture().getWidth();
        robot.interact(() -> preview().requestFocus());
        robot.moveTo("#traced-picture");
        robot.push(KeyCode.TAB);
        assertThat(isThere("#lights")).isFalse();
        assertThat(isShown("toolbar")).isFalse();
        assertThat(picture().getWidth()).isGreaterThan(before + 50);
        robot.push(KeyCode.TAB);
        assertThat(isThere("#lights")).isTrue();
        assertThat(isShown("toolbar")).isTrue();
    }

    private void showTimeline(boolean shown) {
        robot.interact(() -> model().arrangement().timelineShownProperty().set(shown));
        QuickRobot.settle();
    }

    private double timeline() {
        return robot.lookup("#timeline").<Region>query().getHeight();
    }

    @Test
    void timelineThatIsFirstShown_hasRoomForItsRows() {
        showTimeline(true);
        assertThat(timeline()).isBetween(198.0, 200.0);
    }

    @Test
    void timelineThatIsShownAgain_isAsHighAsItWasLeft() {
        showTimeline(true);
        robot.interact(() -> ((SplitPane) robot.lookup("#timeline").query().getParent().getParent()).setDividerPositions(0.5));
        QuickRobot.settle();
        double left = timeline();
        showTimeline(false);
        showTimeline(true);
        assertThat(timeline()).isBetween(left - 1, left + 1);
    }

    @Test
    void tabInAField_goesToTheNextField() {
        robot.interact(() -> robot.lookup("#intensity .number-field").<TextField>query().requestFocus());
        robot.moveTo("#traced-picture");
        robot.push(KeyCode.TAB);
        assertThat(isThere("#lights")).isTrue();
    }

    @Test
    void arrangement_isKeptFromRunToRunAndHiddenPanelsAreNot() {
        arrange(Canvases.PICTURE_LARGE);
        robot.interact(() -> model().commands().run(Command.HIDE_PANELS));
        waitFor("it is written", () -> Files.exists(folder.resolve("own/preferences.properties")));
        waitFor("it is kept", () -> new Preferences(folder.resolve("own"), Runnable::run).is("arrangement", "PICTURE_LARGE"));
    }

    @Test
    void newScene_isWrittenOpenedAndOfTheSizeOfAScreen() throws Exception {
        answer = folder.resolve("fresh");
        robot.interact(() -> model().commands().run(Command.NEW_SCENE));
        waitFor("it is open", () -> model().editor().document().name().equals("fresh.jen"));
        robot.interact(() -> model().commands().run(Command.CANCEL));
        var read = JenReader.read(folder.resolve("fresh.jen")).scene();
        assertThat(read).isEqualTo(model().editor().scene());
        assertThat(List.of(read.picture().width(), read.picture().height())).containsExactly(1280, 720);
        assertThat(read.picture().sampling().antialias()).isEqualTo(Antialias.EDGES);
        assertThat(read.lights()).hasSize(3);
    }
}
