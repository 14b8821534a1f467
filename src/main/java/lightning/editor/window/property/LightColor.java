package lightning.editor.window.property;

import java.util.Optional;
import lightning.editor.document.Dial;
import lightning.editor.document.Hsv;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.scene.LightAttribute;

/** The colour of the selected light. */
record LightColor(EditorModel model) implements ColorSliders.Target {
    @Override
    public Gauge red() {
        return new DialGauge(model, Dial.of(LightAttribute.COLOR).get(0));
    }

    @Override
    public Gauge green() {
        return new DialGauge(model, Dial.of(LightAttribute.COLOR).get(1));
    }

    @Override
    public Gauge blue() {
        return new DialGauge(model, Dial.of(LightAttribute.COLOR).get(2));
    }

    @Override
    public Optional<String> hsv(Hsv color, Object gesture) {
        return model.edit(scene -> LightEdits.hsv(scene, model.selectedLight().name(), color), gesture);
    }

    @Override
    public Optional<String> temperature(double kelvin, Object gesture) {
        return model.edit(scene -> LightEdits.temperature(scene, model.selectedLight().name(), kelvin), gesture);
    }
}
