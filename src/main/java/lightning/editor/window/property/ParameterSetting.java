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
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Numeric setting of the selected light or the scene. */
record ParameterSetting(SceneEditor editor, NumericParameter parameter) implements NumberSetting {

    /** @param visibleState  state as in {@link PropertyPane} */
    static ArrowWidget widget(SceneEditor editor, NumericParameter parameter, ObservableValue<EditorState> visibleState) {
        ArrowWidget widget = new ArrowWidget(SectionLayout.title(parameter.label()), parameter.title(),
                new ParameterSetting(editor, parameter));
        widget.setId(parameter.id());
        visibleState.subscribe(state -> show(state, parameter, widget));
        return widget;
    }

    private static void show(EditorState state, NumericParameter parameter, ArrowWidget widget) {
        Optional<Light> light = state.selectedLight();
        widget.setDisabledReason(parameter.disabledReason(state.scene(), light));
        if (parameter.isOfScene() || light.isPresent()) {
            widget.show(parameter.value(state.scene(), light.map(Light::name).orElse("")));
        } else {
            widget.showNothing();
        }
    }

    @Override
    public String title() {
        return parameter.title();
    }

    @Override
    public NumberUnit measure() {
        return parameter.measure();
    }

    @Override
    public StepRange steps() {
        return parameter.range();
    }

    @Override
    public Optional<String> set(double value, @Nullable Object gesture) {
        return editor.edit(scene -> parameter.set(scene, editor.selection().lightName(), value), gesture);
    }
}
