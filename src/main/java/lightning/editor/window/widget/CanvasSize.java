package lightning.editor.window.widget;

import java.util.List;
import lightning.base.text.Messages;
import lightning.scene.PictureSettings;

/**
 * The size of a canvas.
 *
 * @param title  for menus
 * @param width  pixels; 0 where it follows something else; likewise {@code height}
 */
public record CanvasSize(String title, int width, int height) {
    /** As large as there is room, in the shape of the traced picture. */
    public static final CanvasSize PICTURE_ASPECT = new CanvasSize(Messages.key("Match Aspect Ratio"), 0, 0);
    /** All the room there is. */
    public static final CanvasSize FREE = new CanvasSize(Messages.key("Free"), 0, 0);

    /** The paper's default first. */
    public static final List<CanvasSize> FIXED = List.of(of(200, 200), of(300, 300), of(400, 400), of(600, 600), of(320, 240),
            of(640, 480), of(800, 600), of(1024, 768), of(1280, 720), of(1920, 1080), of(2560, 1440), of(3840, 2160));

    public static CanvasSize of(int width, int height) {
        return new CanvasSize(width + " × " + height, width, height);
    }

    /**
     * A canvas in a window.
     *
     * @param width       pixels that are drawn; likewise {@code height}
     * @param shownWidth  pixels of the window; likewise {@code shownHeight}
     */
    public record Layout(int width, int height, double shownWidth, double shownHeight) {}

    /**
     * How the canvas lies in the room there is; what is too large is shown smaller.
     *
     * @param availableWidth pixels of the window, ≥ 1; likewise {@code availableHeight}
     * @param pixelScale    pixels of the screen for one of the window
     */
    public Layout fit(double availableWidth, double availableHeight, PictureSettings picture, double pixelScale) {
        if (this == FREE) {
            return layout(availableWidth, availableHeight, pixelScale);
        }
        double w = width == 0 ? picture.width() : width;
        double h = height == 0 ? picture.height() : height;
        double fitScale = Math.min(availableWidth / w, availableHeight / h);
        if (width == 0) {
            return layout(Math.max(1, Math.rint(w * fitScale)), Math.max(1, Math.rint(h * fitScale)), pixelScale);
        }
        double shrink = Math.min(1, fitScale);
        return new Layout(width, height, Math.max(1, w * shrink), Math.max(1, h * shrink));
    }

    private static Layout layout(double width, double height, double pixelScale) {
        return new Layout((int) Math.max(1, width * pixelScale), (int) Math.max(1, height * pixelScale), width, height);
    }
}
