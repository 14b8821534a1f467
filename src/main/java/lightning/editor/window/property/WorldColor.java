package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.HsvColor;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.NumericKind;
import lightning.scene.SceneLimits;
import lightning.scene.World;

/** Background color of the scene. */
record WorldColor(SceneEditor editor) implements ColorSliders.Target {
    private static final NumericKind<Rgb> QUANTITY = (NumericKind<Rgb>) World.BACKGROUND.kind();

    /** Creates the sliders of the color. The caller updates them. */
    ColorSliders sliders() {
        var sliders = ColorSliders.forSurface(Messages.tr(World.BACKGROUND.title()),
                Messages.tr("Color behind the scene, also seen in reflections"), SceneLimits.MAX_EMISSION, this);
        sliders.setId("world-background");
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
        return NumberSetting.of(World.BACKGROUND.title() + " " + QUANTITY.labels().get(index),
                new StepRange(QUANTITY.step(), QUANTITY.min(), QUANTITY.max()),
                (v, gesture) -> edit(color -> QUANTITY.with(color, index, v), gesture));
    }

    @Override
    public Optional<String> hsv(HsvColor color, Object gesture) {
        Rgb rgb = color.rgb();
        return edit(_ -> QUANTITY.compose().apply(List.of(rgb.r(), rgb.g(), rgb.b())), gesture);
    }

    private Optional<String> edit(UnaryOperator<Rgb> change, Object gesture) {
        return editor.edit(scene -> EditOutcome
                .of(() -> scene.withWorld(World.BACKGROUND.with(scene.world(), change.apply(scene.world().background())))), gesture);
    }
}
