package lightning.app.traced;

import lightning.app.model.EditorModel;
import lightning.image.DisplayCurve;
import lightning.image.ViewTransform;
import lightning.text.Texts;

/** Which mark says what, while pixels that are cut off are marked. */
final class ClippingLegend extends Legend {
    ClippingLegend(EditorModel model) {
        super("clipping-legend", Texts.of("Marks of pixels that are cut off"),
                model.viewProperty().map(view -> view.marked() && view.curve() != DisplayCurve.FALSE));
        add(Texts.of("brighter than white"), ViewTransform.OVER_WHITE, false);
        add(Texts.of("black"), ViewTransform.BLACK, true);
    }
}
