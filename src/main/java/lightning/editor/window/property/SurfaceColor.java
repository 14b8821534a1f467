package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.text.Texts;
import lightning.editor.document.Hsv;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.Steps;
import lightning.editor.window.model.MaterialChoice;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.Gauge;
import lightning.scene.MaterialAttribute;
import lightning.scene.Quantity;

/** A colour of the edited material. */
record SurfaceColor<V>(SceneEditor editor, MaterialChoice materials, MaterialAttribute<V> attribute, Quantity<V> quantity)
        implements ColorSliders.Target {

    /** The sliders of the colour; whoever made them shows it. */
    ColorSliders sliders() {
        var sliders = ColorSliders.ofSurface(attribute.title(), Texts.of(attribute.help()), quantity.max(), this);
        sliders.setId(attribute.title());
        return sliders;
    }

    @Override
    public Gauge red() {
        return channel(0);
    }

    @Override
    public Gauge green() {
        return channel(1);
    }

    @Override
    public Gauge blue() {
        return channel(2);
    }

    private Gauge channel(int index) {
        return Gauge.of(attribute.title() + " " + quantity.labels().get(index), new Steps(quantity.step(), quantity.min(), quantity.max()),
                (v, gesture) -> edit(color -> quantity.with(color, index, v), gesture));
    }

    @Override
    public Optional<String> hsv(Hsv color, Object gesture) {
        Rgb rgb = color.rgb();
        return edit(_ -> quantity.join().apply(List.of(rgb.r(), rgb.g(), rgb.b())), gesture);
    }

    private Optional<String> edit(UnaryOperator<V> with, Object gesture) {
        var material = materials.material();
        return editor.edit(scene -> MaterialEdits.set(scene, material.name(), attribute, with.apply(attribute.of(material))), gesture);
    }
}
