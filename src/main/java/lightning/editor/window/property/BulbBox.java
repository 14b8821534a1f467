package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.scene.MaterialAttribute;
import lightning.scene.Scene;
import lightning.scene.ValueKind;

/** Combo box for the light whose bulb a material is, including none. */
final class BulbBox extends StackPane {
    private final SceneEditor editor;
    private final ValueKind.NameKind kind;
    private final ComboBox<String> box = new ComboBox<>();
    private final DisabledReason disabledReason;
    private boolean isUpdating;

    /** @param onChosen receives the name of the light, empty for none */
    BulbBox(SceneEditor editor, ValueKind.NameKind kind, Consumer<String> onChosen) {
        this.editor = editor;
        this.kind = kind;
        box.setId(MaterialAttribute.BULB.id());
        box.setAccessibleText(Messages.tr(MaterialAttribute.BULB.title()));
        box.setMaxWidth(Double.MAX_VALUE);
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(String name) {
                return name == null ? "" : name.isEmpty() ? Messages.tr("none") : name;
            }

            @Override
            public String fromString(String text) {
                throw new IllegalStateException("the names are chosen, not typed");
            }
        });
        box.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                onChosen.accept(now);
            }
        });
        box.setOnShowing(_ -> showNames(editor.scene(), box.getValue()));
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, Messages.tr(kind.help()));
    }

    ComboBox<String> box() {
        return box;
    }

    /** Shows the name of a light, empty for none. */
    void show(String light) {
        showNames(editor.scene(), light);
    }

    void showNothing() {
        showNames(editor.scene(), null);
    }

    private void showNames(Scene scene, String value) {
        List<String> names = Stream.concat(Stream.of(""), kind.names().apply(scene).stream()).toList();
        isUpdating = true;
        if (!box.getItems().equals(names)) {
            box.getItems().setAll(names);
        }
        box.setValue(value);
        isUpdating = false;
    }

    /** Disables the box with a reason, as a clause, or enables it. */
    void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
