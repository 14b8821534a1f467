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
import lightning.scene.Scene;
import lightning.scene.attribute.ValueKind;
import org.jspecify.annotations.Nullable;

/** Combo box for a name in the scene, including none. */
class NameChoice extends StackPane {
    private final ValueKind.NameKind kind;
    private final ComboBox<String> box = new ComboBox<>();
    private final DisabledReason disabledReason;
    private boolean isUpdating;

    /**
     * @param id       of the box
     * @param title    title of the attribute, for screen readers
     * @param onChosen receives the name, empty for none
     */
    NameChoice(SceneEditor editor, String id, String title, ValueKind.NameKind kind, Consumer<String> onChosen) {
        this.kind = kind;
        box.setId(id);
        box.setAccessibleText(Messages.tr(title));
        box.setMaxWidth(Double.MAX_VALUE);
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(@Nullable String name) {
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
        box.setOnShowing(_ -> show(editor.scene(), box.getValue()));
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, Messages.tr(kind.help()));
    }

    ComboBox<String> box() {
        return box;
    }

    /**
     * Shows a name.
     *
     * @param scene its names can be chosen
     * @param value empty for none, null for nothing
     */
    void show(Scene scene, @Nullable String value) {
        List<String> names = Stream.concat(Stream.of(""), scene.names(kind.referent()).stream()).toList();
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
