package lightning.editor.window.traced;

import lightning.base.text.Texts;
import lightning.editor.window.model.EditorModel;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

/** Which mark says what, while pixels that are cut off are marked. */
final class ClippingLegend extends Legend {
    ClippingLegend(EditorModel model) {
        super("clipping-legend", Texts.of("Marks of pixels that are cut off"),
                model.viewProperty().map(view -> view.marked() && view.curve() != DisplayCurve.FALSE));
        add(Texts.of("brighter than white"), ViewTransform.OVER_WHITE, false);
        add(Texts.of("black"), ViewTransform.BLACK, true);
    }
}
