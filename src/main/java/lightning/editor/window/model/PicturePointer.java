package lightning.editor.window.model;

import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.render.relight.LightContributions.Region;

/** Which part of the traced picture the artist points at, for panes that are not the picture's. */
public final class PicturePointer {
    /** A pixel, from the left and from the top. */
    public record Pixel(int x, int y) {}

    /**
     * A wish for a frame.
     *
     * @param hint   what the artist shall do: it stands over the picture
     * @param onPicked hears of the frame that was dragged
     */
    public record RegionRequest(String hint, Consumer<Region> onPicked) {}

    private final ObjectProperty<Pixel> pixel = new SimpleObjectProperty<>();
    private final ObjectProperty<RegionRequest> regionRequest = new SimpleObjectProperty<>();

    /** The pixel under the mouse; null where there is none. */
    public ObjectProperty<Pixel> pixelProperty() {
        return pixel;
    }

    /** What the next drag in the picture is for; null where it is for nothing. */
    public ObjectProperty<RegionRequest> regionRequestProperty() {
        return regionRequest;
    }
}
