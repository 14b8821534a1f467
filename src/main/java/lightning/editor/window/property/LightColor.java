package lightning.editor.window.property;

import java.util.Optional;
import lightning.editor.document.HsvColor;
import lightning.editor.document.LightEdits;
import lightning.editor.document.NumericParameter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.light.LightAttribute;
import org.jspecify.annotations.Nullable;

/** Color of the selected light. */
record LightColor(SceneEditor editor) implements ColorSliders.Target {
    @Override
    public NumberSetting red() {
        return new ParameterSetting(editor, NumericParameter.of(LightAttribute.COLOR).get(0));
    }

    @Override
    public NumberSetting green() {
        return new ParameterSetting(editor, NumericParameter.of(LightAttribute.COLOR).get(1));
    }

    @Override
    public NumberSetting blue() {
        return new ParameterSetting(editor, NumericParameter.of(LightAttribute.COLOR).get(2));
    }

    @Override
    public Optional<String> hsv(HsvColor color, @Nullable Object gesture) {
        return editor.edit(scene -> LightEdits.setHsv(scene, editor.selection().lightName(), color), gesture);
    }
}
