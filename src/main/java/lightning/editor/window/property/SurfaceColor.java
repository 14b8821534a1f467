package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.editor.document.HsvColor;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.MaterialAttribute;
import lightning.scene.NumericKind;

/** Color attribute of the edited material. */
record SurfaceColor<V>(SceneEditor editor, MaterialSelection materials, MaterialAttribute<V> attribute, NumericKind<V> quantity)
        implements ColorSliders.Target {

    /** Creates the sliders of the color. The caller updates them. */
    ColorSliders sliders() {
        var sliders = ColorSliders.forSurface(attribute.title(), Messages.tr(attribute.help()), quantity.max(), this);
        sliders.setId(attribute.id());
        return sliders;
    }

    @Override
    public NumberSetting red() {
        return channel(0);
    }

    @Override
    public NumberSetting green() {
        return channel(1);
    }

    @Override
    public NumberSetting blue() {
        return channel(2);
    }

    private NumberSetting channel(int index) {
        return NumberSetting.of(attribute.title() + " " + quantity.labels().get(index),
                new StepRange(quantity.step(), quantity.min(), quantity.max()),
                (v, gesture) -> edit(color -> quantity.with(color, index, v), gesture));
    }

    @Override
    public Optional<String> hsv(HsvColor color, Object gesture) {
        Rgb rgb = color.rgb();
        return edit(_ -> quantity.compose().apply(List.of(rgb.r(), rgb.g(), rgb.b())), gesture);
    }

    private Optional<String> edit(UnaryOperator<V> change, Object gesture) {
        var material = materials.material();
        return editor.edit(scene -> MaterialEdits.set(scene, material.name(), attribute, change.apply(attribute.get(material))), gesture);
    }
}
