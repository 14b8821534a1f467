package lightning.editor.window.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javafx.application.Platform;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.OwnEditor;
import lightning.render.image.ViewTransform;
import lightning.sample.PythonPrograms;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The dialog for views of OpenColorIO. */
class OcioActionsTest extends EditorFixture {
    @BeforeEach
    void requireOpenColorIo() {
        PythonPrograms.require("PyOpenColorIO");
    }

    /** Opens the dialog and enters a configuration. */
    private void open(String config) {
        Platform.runLater(() -> model().commands().run(Command.OCIO_VIEW));
        waitFor("the dialog is open", () -> robot.lookup("#ocio-config").tryQuery().isPresent());
        robot.interact(() -> {
            TextField field = robot.lookup("#ocio-config").query();
            field.setText(config);
            field.fireEvent(new javafx.event.ActionEvent());
        });
    }

    private ComboBox<String> box(String id) {
        return robot.lookup("#" + id).query();
    }

    private void waitForViews() {
        waitFor("the views are listed", () -> box("ocio-view").getValue() != null);
    }

    private void cancel() {
        robot.interact(() -> robot.lookup("#ocio-config").query().getScene().getWindow().hide());
    }

    @Test
    @OwnEditor
    void chosenView_isShownAndKeptNextToTheScene() throws IOException {
        open("ocio://default");
        waitForViews();
        robot.interact(() -> box("ocio-view").setValue("Un-tone-mapped"));
        robot.clickOn("Apply");
        waitFor("the view is shown", () -> model().picture().viewProperty().get().lut().isPresent());
        ViewTransform view = model().picture().viewProperty().get();
        Path kept = view.lut().orElseThrow().file();
        assertThat(kept).exists().hasParent(model().editor().document().file().toAbsolutePath().getParent());
        assertThat(kept.getFileName().toString()).endsWith(".sRGB - Display-Un-tone-mapped.cube");
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(view.toPixels(model().picture().frame().film()));
        assertThat(model().editor().message().textProperty().get()).startsWith("Shows 'sRGB - Display', 'Un-tone-mapped'; error in steps");
        waitFor("the preference is saved",
                () -> Files.readString(folder.resolve("own/preferences.properties")).contains("Un-tone-mapped.cube"));
    }

    @Test
    void brokenConfiguration_isNamedInTheDialog() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.ocio"), "ocio_profile_version: 2\n  bad: [\n");
        ViewTransform before = model().picture().viewProperty().get();
        open(broken.toString());
        waitFor("the error is shown",
                () -> robot.lookup("#ocio-status").<Label>query().getText().contains("cannot be read by OpenColorIO"));
        assertThat(robot.lookup("Apply").query().isDisabled()).isTrue();
        cancel();
        assertThat(model().picture().viewProperty().get()).isEqualTo(before);
    }

    @Test
    void canceledDialog_keepsTheView() {
        ViewTransform before = model().picture().viewProperty().get();
        open("ocio://default");
        waitForViews();
        cancel();
        assertThat(model().picture().viewProperty().get()).isEqualTo(before);
    }
}
