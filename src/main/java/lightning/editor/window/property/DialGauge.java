package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import lightning.base.text.Measure;
import lightning.editor.document.Dial;
import lightning.editor.document.Situation;
import lightning.editor.document.Steps;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.Gauge;
import lightning.scene.Light;

/** A dial of the selected light, or of the scene. */
record DialGauge(SceneEditor editor, Dial dial) implements Gauge {

    /** @param seen as in {@link PropertyPane} */
    static ArrowWidget widget(SceneEditor editor, Dial dial, ObservableValue<Situation> seen) {
        ArrowWidget widget = new ArrowWidget(Sections.title(dial.label()), dial.title(), new DialGauge(editor, dial));
        widget.setId(dial.isOfScene() ? dial.title().replace(' ', '-') : dial.label());
        seen.subscribe(now -> show(now, dial, widget));
        return widget;
    }

    private static void show(Situation now, Dial dial, ArrowWidget widget) {
        Optional<Light> light = now.selected();
        widget.setObstacle(dial.obstacle(now.scene(), light));
        if (dial.isOfScene() || light.isPresent()) {
            widget.show(dial.value(now.scene(), light.map(Light::name).orElse("")));
        } else {
            widget.showNothing();
        }
    }

    @Override
    public String title() {
        return dial.title();
    }

    @Override
    public Measure measure() {
        return dial.measure();
    }

    @Override
    public Steps steps() {
        return dial.steps();
    }

    @Override
    public Optional<String> set(double value, Object gesture) {
        return editor.edit(scene -> dial.set(scene, editor.selection().lightName(), value), gesture);
    }
}
