package lightning.editor.window.sequence;

import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javafx.scene.control.Label;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.format.sequence.Sequence;
import org.jspecify.annotations.Nullable;

/** Fields for the own values and the note of the selected shot, and for the note of the selected light. */
final class ShotDetails extends VBox {
    private static final int ROWS = 3;

    private final Label shotName = new Label();
    private final TextArea overrides = new TextArea();
    private final TextField note = new TextField();
    private final Label lightName = new Label();
    private final TextField lightNote = new TextField();
    private String light = "";
    private boolean isUpdating;

    /**
     * @param onShot      receives changes of the selected shot
     * @param onLightNote receives the name of the selected light and its note
     */
    ShotDetails(Consumer<UnaryOperator<Sequence.Entry>> onShot, BiConsumer<String, String> onLightNote) {
        overrides.setId("sequence-overrides");
        overrides.setPromptText("key.intensity=2");
        overrides.setPrefRowCount(ROWS);
        overrides.setAccessibleText(Messages.tr("Values of the shot, one in each line"));
        overrides.textProperty().subscribe((_, text) -> ifUser(() -> onShot.accept(
                shot -> shot.withOverrides(text.lines().map(String::strip).filter(line -> !line.isEmpty()).toList()))));
        note.setId("sequence-note");
        note.setPromptText(Messages.tr("Note about the shot"));
        note.setAccessibleText(Messages.tr("Note about the shot"));
        note.textProperty().subscribe((_, text) -> ifUser(() -> onShot.accept(shot -> shot.withNote(text))));
        lightNote.setId("sequence-light-note");
        lightNote.setPromptText(Messages.tr("Note about the light, for all shots"));
        lightNote.setAccessibleText(Messages.tr("Note about the selected light"));
        lightNote.textProperty().subscribe((_, text) -> ifUser(() -> onLightNote.accept(light, text)));
        HBox.setHgrow(note, Priority.ALWAYS);
        HBox.setHgrow(lightNote, Priority.ALWAYS);
        shotName.setMinWidth(Region.USE_PREF_SIZE);
        lightName.setMinWidth(Region.USE_PREF_SIZE);
        getChildren().addAll(SequencePane.row(shotName, note), overrides, SequencePane.row(lightName, lightNote));
    }

    private void ifUser(Runnable change) {
        if (!isUpdating) {
            change.run();
        }
    }

    /** Shows a shot; null for none. */
    void show(Sequence.@Nullable Entry shot) {
        isUpdating = true;
        shotName.setText(shot == null ? Messages.tr("Shot") : shot.name());
        overrides.setText(shot == null ? "" : String.join("\n", shot.overrides()));
        note.setText(shot == null ? "" : shot.note());
        isUpdating = false;
    }

    /**
     * Shows the note of a light.
     *
     * @param name its name; empty for no light
     */
    void showLight(String name, String text) {
        isUpdating = true;
        light = name;
        lightName.setText(name.isEmpty() ? Messages.tr("Light") : name);
        lightNote.setDisable(name.isEmpty());
        if (!lightNote.getText().equals(text)) {
            lightNote.setText(text);
        }
        isUpdating = false;
    }
}
