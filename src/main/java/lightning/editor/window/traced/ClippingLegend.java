package lightning.editor.window.traced;

import javafx.beans.value.ObservableValue;
import lightning.base.text.Texts;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

/** Which mark says what, while pixels that are cut off are marked. */
final class ClippingLegend extends Legend {
    ClippingLegend(ObservableValue<ViewTransform> view) {
        super("clipping-legend", Texts.of("Marks of pixels that are cut off"),
                view.map(now -> now.marked() && now.curve() != DisplayCurve.FALSE));
        add(Texts.of("brighter than white"), ViewTransform.OVER_WHITE, false);
        add(Texts.of("black"), ViewTransform.BLACK, true);
    }
}
