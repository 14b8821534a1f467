package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import lightning.base.text.Messages;
import lightning.editor.document.EditorState;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;

/** Combo box for a name attribute of the selected light, including none. */
final class NameBox extends NameChoice {
    private final LightAttribute<String> attribute;

    /** @param visibleState  state as in {@link PropertyPane} */
    NameBox(SceneEditor editor, LightAttribute<String> attribute, ValueKind.NameKind kind, ObservableValue<EditorState> visibleState) {
        super(editor, "light-" + attribute.name(), attribute.title(), kind, now -> {
            String name = editor.selection().lightName();
            editor.editOrReport(scene -> LightEdits.edit(scene, name, light -> attribute.with(light, now)));
        });
        this.attribute = attribute;
        visibleState.subscribe(this::showLight);
    }

    private void showLight(EditorState state) {
        Optional<Light> light = state.selectedLight();
        show(state.scene(), light.map(attribute::get).orElse(null));
        setDisabledReason(
                light.isPresent() ? attribute.inactiveReason(light.get().type()) : Optional.of(Messages.tr("no light is selected")));
    }
}
