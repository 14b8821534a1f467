package lightning.editor.window.traced;

import javafx.beans.value.ObservableValue;
import lightning.base.text.Messages;
import lightning.render.image.DisplayCurve;
import lightning.render.image.FalseColor;
import lightning.render.image.ViewTransform;

/** Legend of the false colors by stop, visible while the picture uses them. */
final class StopLegend extends Legend {
    private static final int DARK_LIMIT = 3 * 0x60;

    StopLegend(ObservableValue<ViewTransform> view) {
        super("stop-legend", Messages.tr("Stops from middle gray (false color)"),
                view.map(now -> now.curve() == DisplayCurve.FALSE));
        for (FalseColor.Band band : FalseColor.bands()) {
            int rgb = band.rgb();
            add(band.stop() > 0 ? "+" + band.stop() : String.valueOf(band.stop()), rgb,
                    (rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF) < DARK_LIMIT);
        }
    }
}
