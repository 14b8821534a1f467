package lightning.editor.window.traced;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.StackPane;
import javafx.scene.shape.Rectangle;
import lightning.base.text.Texts;
import lightning.editor.loop.Frame;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PicturePart;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.widget.PictureView;
import lightning.render.relight.Contributions;
import lightning.render.trace.Geometry;
import lightning.scene.Picture;
import lightning.scene.Scene;

/**
 * The mouse over the traced picture: says what a pixel is made of, selects the light that matters most there, serves the
 * {@link LightPlacer}, frames a region, moves the picture.
 */
final class TracedMouse implements AutoCloseable {
    private final SceneEditor editor;
    private final TracedPicture shown;
    private final PicturePart part;
    private final Executor window;
    private final PictureView picture;
    private final Consumer<PixelReport> hovered;
    private final PixelInspector inspector;
    private final RegionTracer regions = new RegionTracer();
    private final BooleanProperty region = new SimpleBooleanProperty();
    private final ReadOnlyStringWrapper prompt = new ReadOnlyStringWrapper("");
    private final Rectangle frame = new Rectangle();
    private final ShapeMenu menu;
    private final LightPlacer placer;
    private final TracedGizmo gizmo;
    private final StackPane overlay;
    /** Hears of the next click; null where a click selects. */
    private Consumer<PixelReport> pick;
    private String wish = "";
    private boolean hand;
    /** Whether the artist gave the drag up before the button was released. */
    private boolean givenUp;
    /** What the region shows that was traced last; null before the first. */
    private volatile Scene patched;
    private double pressX;
    private double pressY;
    private double lastX;
    private double lastY;

    /** @param hovered hears what the pixel under the mouse shows; null where there is none */
    TracedMouse(EditorModel model, PictureView picture, Consumer<PixelReport> hovered) {
        editor = model.editor();
        shown = model.picture();
        part = model.part();
        window = model.files().window();
        this.picture = picture;
        this.hovered = hovered;
        menu = new ShapeMenu(editor, model.materials(), model.commands());
        inspector = new PixelInspector(window);
        placer = LightPlacer.of(editor, model.commands());
        gizmo = new TracedGizmo(editor, model.previewLook(), picture, placer);
        overlay = new StackPane(gizmo, new Pane(frame));
        overlay.setMouseTransparent(true);
        frame.getStyleClass().add("region-frame");
        frame.setVisible(false);
        frame.setManaged(false);
        picture.setOnMouseMoved(this::hover);
        picture.setOnMouseExited(_ -> leave());
        picture.setOnMousePressed(this::pressed);
        picture.setOnMouseDragged(this::dragged);
        picture.setOnMouseReleased(this::released);
        region.subscribe(_ -> ask());
        placer.promptProperty().subscribe(hint -> {
            pick = hint.isEmpty() ? pick : null;
            ask();
        });
        part.askProperty().subscribe(_ -> ask());
        picture.sceneProperty().subscribe(scene -> {
            if (scene != null) {
                scene.addEventFilter(KeyEvent.KEY_PRESSED, this::key);
                scene.addEventFilter(KeyEvent.ANY, this::space);
            }
        });
    }

    /** While the space bar is held over the picture, the left button moves it. */
    private void space(KeyEvent e) {
        if (e.getCode() != KeyCode.SPACE) {
            return;
        }
        boolean held = e.getEventType() == KeyEvent.KEY_PRESSED && picture.isHover()
                && !(picture.getScene().getFocusOwner() instanceof Control);
        if (held != hand) {
            hand = held;
            ask();
        }
        if (held) {
            e.consume();
        }
    }

    private void key(KeyEvent e) {
        if (e.getCode() != KeyCode.ESCAPE) {
            return;
        }
        if (gizmo.isTaken() || placer.isDragging()) {
            givenUp = true;
            giveUp();
            e.consume();
        } else if (placer.endRing()) {
            gizmo.draw();
            e.consume();
        } else if (!prompt.get().isEmpty()) {
            region.set(false);
            part.askProperty().set(null);
            endPick();
            e.consume();
        }
    }

    private void giveUp() {
        if (gizmo.isTaken()) {
            gizmo.giveUp();
        } else {
            placer.giveUp();
            gizmo.draw();
        }
    }

    /** The next click tells what is there instead of selecting a light; a right click ends it. */
    void pickNext(String hint, Consumer<PixelReport> picked) {
        placer.end();
        pick = picked;
        wish = hint;
        ask();
    }

    /** What the artist shall do in the picture, over which it stands; empty where nothing is asked. */
    ReadOnlyStringProperty promptProperty() {
        return prompt.getReadOnlyProperty();
    }

    /** Lies over the picture. */
    Node overlay() {
        return overlay;
    }

    /** What the region shows that was traced last; null before the first. */
    Scene patched() {
        return patched;
    }

    /** Whether a drag frames a region. */
    BooleanProperty regionProperty() {
        return region;
    }

    private void ask() {
        PicturePart.Ask asked = part.askProperty().get();
        String place = placer.promptProperty().get();
        prompt.set(pick != null ? wish : !place.isEmpty() ? Texts.of("{0}, Shift snaps", place)
                : region.get() ? Texts.of("Drag a frame around what to trace")
                : asked != null ? asked.hint() : "");
        picture.setCursor(hand ? Cursor.OPEN_HAND : prompt.get().isEmpty() ? Cursor.DEFAULT : Cursor.CROSSHAIR);
    }

    private void hover(MouseEvent e) {
        Frame last = shown.frame();
        if (last == null) {
            return;
        }
        Picture size = last.scene().picture();
        picture.pixel(e.getX(), e.getY()).filter(p -> p.x() < size.width() && p.y() < size.height())
                .ifPresentOrElse(p -> point(last, p), this::leave);
    }

    private void point(Frame last, PictureView.Pixel p) {
        part.pointedProperty().set(new PicturePart.Pixel(p.x(), p.y()));
        inspector.ask(last, p.x(), p.y(), report -> {
            if (picture.isHover()) {
                hovered.accept(report);
            }
        });
    }

    private void leave() {
        part.pointedProperty().set(null);
        hovered.accept(null);
    }

    private void pressed(MouseEvent e) {
        menu.hide();
        givenUp = false;
        pressX = e.getX();
        pressY = e.getY();
        lastX = pressX;
        lastY = pressY;
        boolean primary = e.getButton() == MouseButton.PRIMARY && !e.isAltDown() && !hand;
        boolean placing = pick == null && !placer.promptProperty().get().isEmpty();
        boolean free = prompt.get().isEmpty() && !hand && !picture.wipe().isVisible();
        boolean placed = primary && (placing || free) && placer.press(pointer(e), TracedGizmo.TOLERANCE);
        if (free && !placed) {
            gizmo.press(e);
        }
    }

    private LightPlacer.Pointer pointer(MouseEvent e) {
        return new LightPlacer.Pointer(picture.pixel(e.getX(), e.getY()), gizmo.viewport(), gizmo.place(e));
    }

    private void dragged(MouseEvent e) {
        if (givenUp) {
            return;
        }
        if (gizmo.isTaken()) {
            gizmo.drag(e);
            return;
        }
        if (placer.isDragging()) {
            placer.drag(pointer(e), e.isShiftDown());
            gizmo.draw();
            return;
        }
        if (e.getButton() == MouseButton.MIDDLE || e.isAltDown() || hand) {
            picture.pan(e.getX() - lastX, e.getY() - lastY);
        } else if ((region.get() || part.askProperty().get() != null) && !picture.isEmpty()) {
            frame.setX(Math.min(pressX, e.getX()));
            frame.setY(Math.min(pressY, e.getY()));
            frame.setWidth(Math.abs(e.getX() - pressX));
            frame.setHeight(Math.abs(e.getY() - pressY));
            frame.setVisible(true);
        } else if (picture.wipe().isVisible()) {
            picture.wipeTo(e.getX());
        }
        lastX = e.getX();
        lastY = e.getY();
    }

    private void released(MouseEvent e) {
        boolean dragged = gizmo.isTaken() && !e.isStillSincePress();
        gizmo.release();
        if (placer.isDragging()) {
            placer.release(e.isStillSincePress());
            gizmo.draw();
            return;
        }
        if (dragged || givenUp) {
            return;
        }
        if (hand && e.getButton() == MouseButton.PRIMARY) {
            return;
        }
        if (frame.isVisible()) {
            frame.setVisible(false);
            framed(picture.nearest(pressX, pressY), picture.nearest(e.getX(), e.getY()));
        } else if (e.getButton() == MouseButton.SECONDARY && (pick != null || !placer.promptProperty().get().isEmpty())) {
            endPick();
        } else if (e.isStillSincePress() && e.getButton() == MouseButton.PRIMARY && placer.promptProperty().get().isEmpty()) {
            click(e);
        } else if (e.isStillSincePress() && e.getButton() == MouseButton.SECONDARY) {
            offer(e);
        }
    }

    private void offer(MouseEvent e) {
        if (shown.frame() != null) {
            picture.pixel(e.getX(), e.getY()).ifPresent(p -> inspector.ask(shown.frame(), p.x(), p.y(),
                    report -> menu.show(picture, report.shape(), e.getScreenX(), e.getScreenY())));
        }
    }

    private void framed(PictureView.Pixel from, PictureView.Pixel to) {
        PicturePart.Ask asked = part.askProperty().get();
        if (region.get()) {
            traceRegion(from, to);
            region.set(false);
        } else if (asked != null) {
            part.askProperty().set(null);
            asked.picked().accept(new Contributions.Region(Math.min(from.x(), to.x()), Math.min(from.y(), to.y()),
                    Math.max(from.x(), to.x()) + 1, Math.max(from.y(), to.y()) + 1));
        }
    }

    private void traceRegion(PictureView.Pixel from, PictureView.Pixel to) {
        var traced = TracedRaster.Dirty.NONE.plus(from.x(), from.y(), from.x() + 1, from.y() + 1)
                .plus(to.x(), to.y(), to.x() + 1, to.y() + 1);
        TracedRaster.Pixels pixels = shown.raster().pixels();
        Scene scene = editor.scene().withPicture(editor.scene().picture().withSize(pixels.width(), pixels.height()));
        Frame known = shown.frame();
        Function<Scene, Geometry> geometry =
                known == null ? Geometry::new : s -> known.geometry().forScene(s, known.geometry().mirrors());
        regions.trace(scene, geometry, traced, film -> {
            shown.raster().patch(film, traced);
            patched = scene;
            window.execute(shown::repaint);
        }, problem -> window.execute(() -> editor.message().show(Sentence.of(problem))));
    }

    private void click(MouseEvent e) {
        if (shown.frame() == null) {
            return;
        }
        picture.pixel(e.getX(), e.getY()).ifPresent(p -> inspector.ask(shown.frame(), p.x(), p.y(), report -> {
            if (pick == null) {
                report.strongest().ifPresent(editor.selection()::selectLight);
            } else if (report.point() == null) {
                editor.message().show(Texts.of("There is nothing there; click a shape"));
            } else {
                Consumer<PixelReport> picked = pick;
                endPick();
                picked.accept(report);
            }
        }));
    }

    private void endPick() {
        pick = null;
        placer.end();
        ask();
    }

    @Override
    public void close() {
        inspector.close();
        regions.close();
    }
}
