package lightning.editor.window.property;

import java.util.stream.Stream;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.render.image.DisplayCurve;

/** Titles of the view transforms, as in the menu. */
final class CurveTitles extends StringConverter<DisplayCurve> {
    @Override
    public String toString(DisplayCurve curve) {
        return curve == null ? "" : Messages.tr(curve.title());
    }

    @Override
    public DisplayCurve fromString(String title) {
        return Stream.of(DisplayCurve.values()).filter(c -> toString(c).equals(title)).findFirst().orElse(null);
    }
}
