package lightning.app;

import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Rectangle;
import lightning.edit.Command;
import lightning.edit.LightEdits;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * The mouse over the traced picture: says what a pixel is made of, selects the light that matters most there, aims the
 * selected light, frames a region, moves the picture.
 */
final class TracedMouse implements AutoCloseable {
    private final EditorModel model;
    private final PictureView picture;
    private final Consumer<PixelReport> hovered;
    private final PixelInspector inspector;
    private final RegionTracer regions = new RegionTracer();
    private final BooleanProperty region = new SimpleBooleanProperty();
    private final Rectangle frame = new Rectangle();
    private final Pane overlay = new Pane(frame);
    private boolean aiming;
    private double pressX;
    private double pressY;
    private double lastX;
    private double lastY;

    /** @param hovered hears what the pixel under the mouse shows; null where there is none */
    TracedMouse(EditorModel model, PictureView picture, Consumer<PixelReport> hovered) {
        this.model = model;
        this.picture = picture;
        this.hovered = hovered;
        inspector = new PixelInspector(model.window());
        overlay.setMouseTransparent(true);
        frame.getStyleClass().add("region-frame");
        frame.setVisible(false);
        frame.setManaged(false);
        picture.setOnMouseMoved(this::hover);
        picture.setOnMouseExited(_ -> leave());
        picture.setOnMousePressed(this::pressed);
        picture.setOnMouseDragged(this::dragged);
        picture.setOnMouseReleased(this::released);
        region.subscribe(_ -> cursor());
        model.setAction(Command.AIM, () -> {
            aiming = true;
            model.say("Click where the light should shine to");
            cursor();
        });
    }

    /** Lies over the picture. */
    Node overlay() {
        return overlay;
    }

    /** Whether a drag frames a region. */
    BooleanProperty regionProperty() {
        return region;
    }

    private void cursor() {
        picture.setCursor(aiming || region.get() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    }

    private void hover(MouseEvent e) {
        if (model.frame() == null) {
            return;
        }
        Scene scene = model.frame().scene();
        picture.pixel(e.getX(), e.getY()).filter(p -> p.x() < scene.picture().width() && p.y() < scene.picture().height())
                .ifPresentOrElse(p -> inspector.ask(scene, p.x(), p.y(), report -> {
                    if (picture.isHover()) {
                        hovered.accept(report);
                    }
                }), this::leave);
    }

    private void leave() {
        hovered.accept(null);
    }

    private void pressed(MouseEvent e) {
        pressX = e.getX();
        pressY = e.getY();
        lastX = pressX;
        lastY = pressY;
    }

    private void dragged(MouseEvent e) {
        if (e.getButton() == MouseButton.MIDDLE || e.isAltDown()) {
            picture.pan(e.getX() - lastX, e.getY() - lastY);
        } else if (region.get() && !picture.isEmpty()) {
            frame.setX(Math.min(pressX, e.getX()));
            frame.setY(Math.min(pressY, e.getY()));
            frame.setWidth(Math.abs(e.getX() - pressX));
            frame.setHeight(Math.abs(e.getY() - pressY));
            frame.setVisible(true);
        }
        lastX = e.getX();
        lastY = e.getY();
    }

    private void released(MouseEvent e) {
        if (frame.isVisible()) {
            frame.setVisible(false);
            traceRegion(picture.nearest(pressX, pressY), picture.nearest(e.getX(), e.getY()));
            region.set(false);
        } else if (e.isStillSincePress() && e.getButton() == MouseButton.PRIMARY) {
            click(e);
        }
    }

    private void traceRegion(PictureView.Pixel from, PictureView.Pixel to) {
        var part = TracedRaster.Dirty.NONE.plus(from.x(), from.y(), from.x() + 1, from.y() + 1)
                .plus(to.x(), to.y(), to.x() + 1, to.y() + 1);
        TracedRaster.Pixels shown = model.raster().pixels();
        Scene scene = model.scene().withPicture(model.scene().picture().withSize(shown.width(), shown.height()));
        regions.trace(scene, part, film -> {
            model.raster().patch(film, part);
            model.window().execute(model::repaint);
        }, problem -> model.window().execute(() -> model.say(Sentence.of(problem))));
    }

    private void click(MouseEvent e) {
        if (model.frame() == null) {
            return;
        }
        picture.pixel(e.getX(), e.getY()).ifPresent(p -> inspector.ask(model.frame().scene(), p.x(), p.y(), report -> {
            if (aiming) {
                aim(report);
            } else {
                report.strongest().ifPresent(model::selectLight);
            }
        }));
    }

    private void aim(PixelReport report) {
        aiming = false;
        cursor();
        Light light = model.selectedLight();
        if (light == null || report.point() == null) {
            model.say("There is nothing to aim at");
            return;
        }
        model.edit(scene -> LightEdits.aim(scene, light.name(), report.point())).ifPresent(model::say);
    }

    @Override
    public void close() {
        inspector.close();
        regions.close();
    }
}
