package lightning.editor.window.traced;

import javafx.beans.value.ObservableValue;
import lightning.base.text.Messages;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;

/** Legend of the clipping marks, visible while clipped pixels are marked. */
final class ClippingLegend extends Legend {
    ClippingLegend(ObservableValue<ViewTransform> view) {
        super("clipping-legend", Messages.tr("Clipped pixels"),
                view.map(now -> now.marksClipping() && now.curve() != DisplayCurve.FALSE));
        add(Messages.tr("brighter than white"), ViewTransform.CLIPPED_MARK, false);
        add(Messages.tr("black"), ViewTransform.BLACK_MARK, true);
    }
}
