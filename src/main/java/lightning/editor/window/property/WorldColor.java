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
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Background color of the scene. */
record WorldColor(SceneEditor editor) implements AttributeColor<Rgb> {
    private static final NumericKind<Rgb> QUANTITY = (NumericKind<Rgb>) World.BACKGROUND.kind();

    /** Creates the sliders of the color. The caller updates them. */
    ColorSliders sliders() {
        var sliders = ColorSliders.forSurface(Messages.tr(World.BACKGROUND.title()),
                Messages.tr("Color behind the scene, also seen in reflections"), SceneLimits.MAX_EMISSION, this);
        sliders.setId("world-background");
        return sliders;
    }

    @Override
    public String title() {
        return World.BACKGROUND.title();
    }

    @Override
    public NumericKind<Rgb> quantity() {
        return QUANTITY;
    }

    @Override
    public Optional<String> edit(UnaryOperator<Rgb> change, @Nullable Object gesture) {
        return editor.edit(scene -> EditOutcome
                .of(() -> scene.withWorld(World.BACKGROUND.with(scene.world(), change.apply(scene.world().background())))), gesture);
    }
}
