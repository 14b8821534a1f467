package lightning.editor.window.property;

import java.util.Optional;
import lightning.editor.document.Dial;
import lightning.editor.document.Hsv;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.scene.LightAttribute;

/** The colour of the selected light. */
record LightColor(SceneEditor editor) implements ColorSliders.Target {
    @Override
    public Gauge red() {
        return new DialGauge(editor, Dial.of(LightAttribute.COLOR).get(0));
    }

    @Override
    public Gauge green() {
        return new DialGauge(editor, Dial.of(LightAttribute.COLOR).get(1));
    }

    @Override
    public Gauge blue() {
        return new DialGauge(editor, Dial.of(LightAttribute.COLOR).get(2));
    }

    @Override
    public Optional<String> hsv(Hsv color, Object gesture) {
        return editor.edit(scene -> LightEdits.hsv(scene, editor.selection().lightName(), color), gesture);
    }

    @Override
    public Optional<String> temperature(double kelvin, Object gesture) {
        return editor.edit(scene -> LightEdits.temperature(scene, editor.selection().lightName(), kelvin), gesture);
    }
}
