package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import lightning.base.text.NumberUnit;
import lightning.editor.document.EditorState;
import lightning.editor.document.NumericParameter;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.Light;

/** A dial of the selected light, or of the scene. */
record ParameterSetting(SceneEditor editor, NumericParameter dial) implements NumberSetting {

    /** @param visibleState as in {@link PropertyPane} */
    static ArrowWidget widget(SceneEditor editor, NumericParameter dial, ObservableValue<EditorState> visibleState) {
        ArrowWidget widget = new ArrowWidget(SectionLayout.title(dial.label()), dial.title(), new ParameterSetting(editor, dial));
        widget.setId(dial.isOfScene() ? dial.title().replace(' ', '-') : dial.label());
        visibleState.subscribe(state -> show(state, dial, widget));
        return widget;
    }

    private static void show(EditorState state, NumericParameter dial, ArrowWidget widget) {
        Optional<Light> light = state.selectedLight();
        widget.setDisabledReason(dial.disabledReason(state.scene(), light));
        if (dial.isOfScene() || light.isPresent()) {
            widget.show(dial.value(state.scene(), light.map(Light::name).orElse("")));
        } else {
            widget.showNothing();
        }
    }

    @Override
    public String title() {
        return dial.title();
    }

    @Override
    public NumberUnit measure() {
        return dial.measure();
    }

    @Override
    public StepRange steps() {
        return dial.range();
    }

    @Override
    public Optional<String> set(double value, Object gesture) {
        return editor.edit(scene -> dial.set(scene, editor.selection().lightName(), value), gesture);
    }
}
