package lightning.editor.window.traced;

import lightning.base.text.Texts;
import lightning.editor.window.model.EditorModel;
import lightning.render.image.DisplayCurve;
import lightning.render.image.FalseColor;

/** Which color stands for which stop, while the picture is shown in such colors. */
final class StopLegend extends Legend {
    private static final int DARK = 3 * 0x60;

    StopLegend(EditorModel model) {
        super("stop-legend", Texts.of("Stops from middle grey, by colour"),
                model.viewProperty().map(view -> view.curve() == DisplayCurve.FALSE));
        for (FalseColor.Band band : FalseColor.bands()) {
            int rgb = band.rgb();
            add(band.stop() > 0 ? "+" + band.stop() : String.valueOf(band.stop()), rgb,
                    (rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF) < DARK);
        }
    }
}
