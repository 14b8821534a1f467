package lightning.editor.window.widget;

import javafx.geometry.Rectangle2D;
import javafx.scene.Group;
import javafx.scene.image.ImageView;
import javafx.scene.shape.Line;

/** A/B comparison: a stored picture over the left part of the current one, with a movable border. */
public final class Wipe extends Group {
    private final ImageView image = new ImageView();
    private final Line border = new Line();
    private double share = 0.5;
    private int width;
    private int height;

    Wipe() {
        setMouseTransparent(true);
        setManaged(false);
        setVisible(false);
        border.getStyleClass().add("wipe-border");
        getChildren().addAll(image, border);
    }

    /** Stores a copy of the pixels, {@code int[width * height]}. */
    public void store(int newWidth, int newHeight, int[] pixels) {
        width = newWidth;
        height = newHeight;
        image.setImage(PixelImage.of(width, height, pixels.clone()));
    }

    boolean isStored() {
        return image.getImage() != null;
    }

    /** @param v  visible share of the stored picture from the left, 0…1 */
    void setShare(double v) {
        share = Math.clamp(v, 0, 1);
    }

    public double share() {
        return share;
    }

    /** Positions the wipe over a picture; position and size in logical pixels. */
    void layout(double left, double top, double displayWidth, double displayHeight, boolean smooth) {
        double visibleWidth = Math.max(1, Math.rint(share * width));
        image.setViewport(new Rectangle2D(0, 0, visibleWidth, height));
        image.setFitWidth(visibleWidth / width * displayWidth);
        image.setFitHeight(displayHeight);
        image.setSmooth(smooth);
        image.relocate(left, top);
        border.setStartX(left + image.getFitWidth());
        border.setEndX(left + image.getFitWidth());
        border.setStartY(top);
        border.setEndY(top + displayHeight);
    }
}
