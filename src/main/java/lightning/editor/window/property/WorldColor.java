package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.scene.World;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/**
 * Color of the scene's world.
 *
 * @param attribute the color
 * @param id        id of its control
 * @param help      what it is, for a tooltip
 */
record WorldColor(SceneEditor editor, SceneAttribute<World, Rgb> attribute, String id, String help) implements AttributeColor<Rgb> {

    /** Creates the sliders of the color. The caller updates them. */
    ColorSliders sliders() {
        var sliders = ColorSliders.forSurface(Messages.tr(attribute.title()), help, quantity().max(), this);
        sliders.setId(id);
        return sliders;
    }

    @Override
    public String title() {
        return attribute.title();
    }

    @Override
    public NumericKind<Rgb> quantity() {
        return (NumericKind<Rgb>) attribute.kind();
    }

    @Override
    public Optional<String> edit(UnaryOperator<Rgb> change, @Nullable Object gesture) {
        return editor.edit(scene -> EditOutcome
                .of(() -> scene.withWorld(attribute.with(scene.world(), change.apply(attribute.get(scene.world()))))), gesture);
    }
}
