package lightning.editor.window.widget;

import java.util.List;
import lightning.base.text.Messages;
import lightning.scene.PictureSettings;

/**
 * Size of a canvas.
 *
 * @param title  title for menus
 * @param width  pixels; 0 if it depends on the available space
 * @param height  pixels; 0 if it depends on the available space
 */
public record CanvasSize(String title, int width, int height) {
    /** Fills the available space with the aspect ratio of the traced picture. */
    public static final CanvasSize PICTURE_ASPECT = new CanvasSize(Messages.key("Match Aspect Ratio"), 0, 0);
    /** Fills the available space. */
    public static final CanvasSize FREE = new CanvasSize(Messages.key("Free"), 0, 0);

    /** Fixed sizes, the paper's default first. */
    public static final List<CanvasSize> FIXED = List.of(of(200, 200), of(300, 300), of(400, 400), of(600, 600), of(320, 240),
            of(640, 480), of(800, 600), of(1024, 768), of(1280, 720), of(1920, 1080), of(2560, 1440), of(3840, 2160));

    public static CanvasSize of(int width, int height) {
        return new CanvasSize(width + " × " + height, width, height);
    }

    /**
     * Placement of a canvas in a window.
     *
     * @param width  rendered pixels
     * @param height  rendered pixels
     * @param shownWidth  displayed width, logical pixels
     * @param shownHeight  displayed height, logical pixels
     */
    public record Layout(int width, int height, double shownWidth, double shownHeight) {}

    /**
     * Fits the canvas into the available space. A canvas that is too large is displayed smaller.
     *
     * @param availableWidth  logical pixels, ≥ 1
     * @param availableHeight  logical pixels, ≥ 1
     * @param pixelScale  physical pixels per logical pixel
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
