package lightning.editor.window.model;

import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.render.relight.LightContributions.Region;

/** Pointer position and region requests in the traced picture, shared with other panes. */
public final class PicturePointer {
    /** Pixel position, from the top left. */
    public record Pixel(int x, int y) {}

    /**
     * Request to drag a region in the picture.
     *
     * @param hint  instruction shown over the picture
     * @param onPicked  receives the dragged region
     */
    public record RegionRequest(String hint, Consumer<Region> onPicked) {}

    private final ObjectProperty<Pixel> pixel = new SimpleObjectProperty<>();
    private final ObjectProperty<RegionRequest> regionRequest = new SimpleObjectProperty<>();

    /** Pixel under the mouse, or null. */
    public ObjectProperty<Pixel> pixelProperty() {
        return pixel;
    }

    /** Request that the next drag in the picture fulfills, or null. */
    public ObjectProperty<RegionRequest> regionRequestProperty() {
        return regionRequest;
    }
}
