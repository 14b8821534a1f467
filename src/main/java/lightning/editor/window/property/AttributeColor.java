package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.editor.document.HsvColor;
import lightning.editor.document.StepRange;
import lightning.editor.window.widget.ColorSliders;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.attribute.NumericKind;
import org.jspecify.annotations.Nullable;

/** Color attribute that sliders edit. */
interface AttributeColor<V> extends ColorSliders.Target {
    String title();

    NumericKind<V> quantity();

    /** Changes the color; returns why it cannot be changed, or nothing. */
    Optional<String> edit(UnaryOperator<V> change, @Nullable Object gesture);

    @Override
    default NumberSetting red() {
        return channel(0);
    }

    @Override
    default NumberSetting green() {
        return channel(1);
    }

    @Override
    default NumberSetting blue() {
        return channel(2);
    }

    private NumberSetting channel(int index) {
        return NumberSetting.of(title() + " " + quantity().labels().get(index),
                new StepRange(quantity().step(), quantity().min(), quantity().max()),
                (v, gesture) -> edit(color -> quantity().with(color, index, v), gesture));
    }

    @Override
    default Optional<String> hsv(HsvColor color, @Nullable Object gesture) {
        Rgb rgb = color.rgb();
        return edit(_ -> quantity().compose().apply(List.of(rgb.r(), rgb.g(), rgb.b())), gesture);
    }
}
