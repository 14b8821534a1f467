package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.editor.document.EditorState;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisabledReason;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.ValueKind;

/** Combo box for a name attribute of the selected light, including none. */
final class NameBox extends StackPane {
    private final LightAttribute<String> attribute;
    private final ValueKind.NameKind kind;
    private final ComboBox<String> box = new ComboBox<>();
    private final DisabledReason disabledReason;
    private boolean isUpdating;

    /** @param visibleState  state as in {@link PropertyPane} */
    NameBox(SceneEditor editor, LightAttribute<String> attribute, ValueKind.NameKind kind, ObservableValue<EditorState> visibleState) {
        this.attribute = attribute;
        this.kind = kind;
        box.setId("light-" + attribute.name());
        box.setAccessibleText(Messages.tr(attribute.title()));
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
                String name = editor.selection().lightName();
                editor.editOrReport(scene -> LightEdits.edit(scene, name, light -> attribute.with(light, now)));
            }
        });
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, Messages.tr(kind.help()));
        visibleState.subscribe(this::show);
    }

    private void show(EditorState state) {
        Optional<Light> light = state.selectedLight();
        isUpdating = true;
        List<String> names = Stream.concat(Stream.of(""), kind.names().apply(state.scene()).stream()).toList();
        if (!box.getItems().equals(names)) {
            box.getItems().setAll(names);
        }
        box.setValue(light.map(attribute::get).orElse(null));
        isUpdating = false;
        disabledReason
                .set(light.isPresent() ? attribute.inactiveReason(light.get().type()) : Optional.of(Messages.tr("no light is selected")));
    }
}
