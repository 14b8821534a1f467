package lightning.editor.window.property;

import java.util.stream.Stream;
import javafx.util.StringConverter;
import lightning.base.text.Messages;
import lightning.render.image.DisplayCurve;
import org.jspecify.annotations.Nullable;

/** Titles of the view transforms, as in the menu. */
final class CurveTitles extends StringConverter<DisplayCurve> {
    @Override
    public String toString(@Nullable DisplayCurve curve) {
        return curve == null ? "" : Messages.tr(curve.title());
    }

    @Override
    public @Nullable DisplayCurve fromString(String title) {
        return Stream.of(DisplayCurve.values()).filter(c -> toString(c).equals(title)).findFirst().orElse(null);
    }
}
