package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.editor.document.MaterialEdits;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.scene.attribute.NumericKind;
import lightning.scene.material.MaterialAttribute;
import org.jspecify.annotations.Nullable;

/** Color attribute of the edited material. */
record SurfaceColor<V>(SceneEditor editor, MaterialSelection materials, MaterialAttribute<V> attribute, NumericKind<V> quantity)
        implements AttributeColor<V> {

    /** Creates the sliders of the color. The caller updates them. */
    ColorSliders sliders() {
        var sliders = ColorSliders.forSurface(attribute.title(), Messages.tr(attribute.help()), quantity.max(), this);
        sliders.setId(attribute.id());
        return sliders;
    }

    @Override
    public String title() {
        return attribute.title();
    }

    @Override
    public Optional<String> edit(UnaryOperator<V> change, @Nullable Object gesture) {
        var material = requireNonNull(materials.material());
        return editor.edit(scene -> MaterialEdits.set(scene, material.name(), attribute, change.apply(attribute.get(material))), gesture);
    }
}
