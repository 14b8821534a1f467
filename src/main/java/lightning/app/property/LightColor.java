package lightning.app.property;

import java.util.Optional;
import lightning.app.model.EditorModel;
import lightning.app.widget.ColorSliders;
import lightning.app.widget.Gauge;
import lightning.edit.Dial;
import lightning.edit.Hsv;
import lightning.edit.LightEdits;
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
