package lightning.editor.window.model;

import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.render.relight.Contributions.Region;

/** Which part of the traced picture the artist points at, for panes that are not the picture's. */
public final class PicturePart {
    /** A pixel, from the left and from the top. */
    public record Pixel(int x, int y) {}

    /**
     * A wish for a frame.
     *
     * @param hint   what the artist shall do: it stands over the picture
     * @param picked hears of the frame that was dragged
     */
    public record Ask(String hint, Consumer<Region> picked) {}

    private final ObjectProperty<Pixel> pointed = new SimpleObjectProperty<>();
    private final ObjectProperty<Ask> ask = new SimpleObjectProperty<>();

    /** The pixel under the mouse; null where there is none. */
    public ObjectProperty<Pixel> pointedProperty() {
        return pointed;
    }

    /** What the next drag in the picture is for; null where it is for nothing. */
    public ObjectProperty<Ask> askProperty() {
        return ask;
    }
}
