package lightning.editor.window.widget;

import static java.util.Objects.requireNonNull;

import java.nio.IntBuffer;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Bounds;
import javafx.geometry.Rectangle2D;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import lightning.document.PictureArea;
import org.jspecify.annotations.Nullable;

/** View of a pixel buffer that changes in place, fitted to the view or zoomed and panned. */
public final class PictureView extends Region {
    private static final double MIN_ZOOM = 1 / 32.0;
    private static final double MAX_ZOOM = 64;
    /** Distance of notes from the edges of the view, pixels. */
    public static final double MARGIN = 12;

    /** Pixel position in the picture. */
    public record Pixel(int x, int y) {}

    private final ImageView image = new ImageView();
    private final Wipe wipe = new Wipe();
    /** Note shown over the picture. */
    private @Nullable UnstyledNote note;
    private final ReadOnlyBooleanWrapper empty = new ReadOnlyBooleanWrapper(true);
    private @Nullable PixelBuffer<IntBuffer> buffer;
    private boolean fitsView = true;
    private double zoom = 1;
    /** Offset of the picture's center from the view's center, logical pixels. */
    private double shiftX;
    private double shiftY;

    public PictureView() {
        var clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        getChildren().addAll(image, wipe);
        setOnScroll(e -> {
            if (e.getDeltaY() != 0) {
                zoomBy(Math.exp(e.getDeltaY() / 200), e.getX(), e.getY());
            }
        });
    }

    /** Shows pixels, {@code int[width * height]}, without copying them. */
    public void setPixels(int width, int height, int[] pixels) {
        buffer = new PixelBuffer<>(width, height, IntBuffer.wrap(pixels), PixelFormat.getIntArgbPreInstance());
        image.setImage(new WritableImage(buffer));
        empty.set(false);
        requestLayout();
    }

    /** Updates a region whose pixels changed. */
    public void updateRegion(int left, int top, int right, int bottom) {
        shownBuffer().updateBuffer(_ -> new Rectangle2D(left, top, right - left, bottom - top));
    }

    /** Shows a note that needs no style sheet; empty for none. */
    public void showNote(String text) {
        getChildren().remove(note);
        note = text.isEmpty() ? null : new UnstyledNote(text);
        if (note != null) {
            getChildren().add(note);
        }
    }

    /** Returns the displayed pixels, {@code int[width * height]}, opaque 0xFFRRGGBB, top row first. */
    public int[] pixels() {
        int width = shownBuffer().getWidth();
        int height = shownBuffer().getHeight();
        int[] pixels = new int[width * height];
        image.getImage().getPixelReader().getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), pixels, 0, width);
        return pixels;
    }

    public boolean isEmpty() {
        return empty.get();
    }

    public ReadOnlyBooleanProperty emptyProperty() {
        return empty.getReadOnlyProperty();
    }

    /** Removes the picture. */
    public void clear() {
        buffer = null;
        empty.set(true);
        image.setImage(null);
    }

    /** Fits the whole picture to the view. */
    public void fit() {
        fitsView = true;
        shiftX = 0;
        shiftY = 0;
        requestLayout();
    }

    /** Shows the picture at one physical pixel per picture pixel. */
    public void showActualSize() {
        fitsView = false;
        zoom = 1 / screenScale();
        shiftX = 0;
        shiftY = 0;
        requestLayout();
    }

    /** Zooms about a fixed point of the view. */
    public void zoomBy(double factor, double x, double y) {
        if (isEmpty()) {
            return;
        }
        double oldScale = scale();
        zoom = Math.clamp(oldScale * factor, MIN_ZOOM, MAX_ZOOM);
        double ratio = zoom / oldScale;
        shiftX = (shiftX + getWidth() / 2 - x) * ratio + x - getWidth() / 2;
        shiftY = (shiftY + getHeight() / 2 - y) * ratio + y - getHeight() / 2;
        fitsView = false;
        requestLayout();
    }

    /** Zooms about the center. */
    public void zoomBy(double factor) {
        zoomBy(factor, getWidth() / 2, getHeight() / 2);
    }

    /** Pans the picture, logical pixels. */
    public void pan(double x, double y) {
        shiftX += x;
        shiftY += y;
        fitsView = false;
        requestLayout();
    }

    /** Returns the physical pixels per picture pixel, for example 1.5. */
    public double magnification() {
        return isEmpty() ? 1 : scale() * screenScale();
    }

    /** Returns the pixel at a point of the view, or empty outside the picture. */
    public Optional<Pixel> pixel(double x, double y) {
        if (isEmpty()) {
            return Optional.empty();
        }
        int px = (int) Math.floor((x - image.getLayoutX()) / scale());
        int py = (int) Math.floor((y - image.getLayoutY()) / scale());
        boolean inside = px >= 0 && py >= 0 && px < shownBuffer().getWidth() && py < shownBuffer().getHeight();
        return inside ? Optional.of(new Pixel(px, py)) : Optional.empty();
    }

    /** Returns the picture's pixel nearest to a point of the view. */
    public Pixel nearestPixel(double x, double y) {
        double px = Math.floor((x - image.getLayoutX()) / scale());
        double py = Math.floor((y - image.getLayoutY()) / scale());
        return new Pixel((int) Math.clamp(px, 0, shownBuffer().getWidth() - 1),
                (int) Math.clamp(py, 0, shownBuffer().getHeight() - 1));
    }

    /** Bounds of the whole picture in the view, logical pixels; they may exceed the view. */
    public ObservableValue<Bounds> pictureBoundsProperty() {
        return image.boundsInParentProperty();
    }

    /** Returns the wipe against a stored picture. */
    public Wipe wipe() {
        return wipe;
    }

    /** Moves the border of the wipe to a point of the view. */
    public void wipeTo(double x) {
        wipe.setShare((x - image.getLayoutX()) / Math.max(1, image.getFitWidth()));
        requestLayout();
    }

    /** Returns the area of the view, physical pixels. */
    public PictureArea area() {
        return PictureArea.of(getWidth() * screenScale(), getHeight() * screenScale());
    }

    private double screenScale() {
        return getScene() == null || getScene().getWindow() == null ? 1 : getScene().getWindow().getOutputScaleX();
    }

    private double scale() {
        if (!fitsView || isEmpty()) {
            return zoom;
        }
        double fitScale = Math.min(getWidth() / shownBuffer().getWidth(), getHeight() / shownBuffer().getHeight());
        return Math.max(fitScale, 1e-3);
    }

    @Override
    protected void layoutChildren() {
        if (note != null) {
            note.resizeRelocate(MARGIN, MARGIN, note.prefWidth(-1), note.prefHeight(-1));
        }
        if (isEmpty()) {
            return;
        }
        double scale = scale();
        double width = shownBuffer().getWidth() * scale;
        double height = shownBuffer().getHeight() * scale;
        image.setFitWidth(width);
        image.setFitHeight(height);
        // Magnified pixels stay sharp squares, so that single ones can be judged.
        image.setSmooth(fitsView || scale * screenScale() < 2);
        image.relocate(Math.rint((getWidth() - width) / 2 + shiftX), Math.rint((getHeight() - height) / 2 + shiftY));
        if (wipe.isStored()) {
            wipe.layout(image.getLayoutX(), image.getLayoutY(), width, height, image.isSmooth());
        }
    }

    /** Returns the buffer of the view, which is not empty. */
    private PixelBuffer<IntBuffer> shownBuffer() {
        return requireNonNull(buffer);
    }
}
