package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Pane;
import javafx.scene.layout.StackPane;
import javafx.scene.shape.Rectangle;
import lightning.base.text.Messages;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.document.manipulation.CameraDrag;
import lightning.editor.window.command.MaterialDrop;
import lightning.editor.window.model.CameraNavigation;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.PicturePointer;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.widget.PictureView;
import lightning.render.relight.LightContributions;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Mouse handler of the traced picture: inspects pixels, selects objects and lights, runs the {@link LightPlacer}, frames a
 * region, and pans the picture.
 */
final class TracedMouse implements AutoCloseable {
    /** Distance of a drag that zooms by a factor of e, pixels. */
    private static final double ZOOM_PIXELS = 150;

    private final SceneEditor editor;
    private final PreviewSettings settings;
    private final TracedPicture tracedPicture;
    private final PicturePointer picturePart;
    private final Executor windowExecutor;
    private final PictureView picture;
    private final Consumer<PixelReport> onHover;
    private final PixelInspector inspector;
    /** Inspects clicked pixels: the reports on hovered ones must not replace them. */
    private final PixelInspector clickInspector;
    private final RegionTracer regionTracer = new RegionTracer();
    private final BooleanProperty regionMode = new SimpleBooleanProperty();
    private final ReadOnlyStringWrapper prompt = new ReadOnlyStringWrapper("");
    private final Rectangle regionFrame = new Rectangle();
    private final PixelMenu menu;
    private final LightPlacer placer;
    private final CameraMover cameraMover;
    private final TracedGizmo gizmo;
    private final StackPane overlay;
    /** Receives the pixel of the next click; null if a click selects what it hits. */
    private @Nullable Consumer<PixelReport> onPick;
    private String pickHint = "";
    private boolean isPanning;
    /** Motion of the image during the current drag; null if the drag does not move it. */
    private @Nullable CameraDrag viewDrag;
    /** True if the user canceled the drag before releasing the button. */
    private boolean isCanceled;
    /** Scene of the last traced region; null before the first. */
    private volatile @Nullable Scene patchedScene;
    private double pressX;
    private double pressY;
    private double lastX;
    private double lastY;

    /**
     * Attaches the handlers.
     *
     * @param onHover receives the report on the pixel under the mouse; null if there is none
     */
    TracedMouse(EditorModel model, PictureView picture, Consumer<PixelReport> onHover) {
        editor = model.editor();
        settings = model.previewSettings();
        tracedPicture = model.picture();
        picturePart = model.picturePointer();
        windowExecutor = model.files().windowExecutor();
        this.picture = picture;
        this.onHover = onHover;
        inspector = new PixelInspector(windowExecutor);
        clickInspector = new PixelInspector(windowExecutor);
        placer = LightPlacer.register(editor, model.commands());
        menu = new PixelMenu(model, placer);
        cameraMover = CameraMover.register(model.commands(), editor, settings);
        gizmo = new TracedGizmo(editor, model.previewSettings(), picture, placer);
        overlay = new StackPane(gizmo, new Pane(regionFrame));
        overlay.setMouseTransparent(true);
        regionFrame.getStyleClass().add("region-frame");
        regionFrame.setVisible(false);
        regionFrame.setManaged(false);
        picture.setOnMouseMoved(this::hover);
        picture.setOnMouseExited(_ -> clearHover());
        picture.setOnMousePressed(this::handlePress);
        picture.setOnMouseDragged(this::handleDrag);
        picture.setOnMouseReleased(this::handleRelease);
        MaterialDrop.accept(picture, (material, e) -> dropMaterial(model.materials(), material, e.getX(), e.getY()));
        regionMode.subscribe(_ -> updatePrompt());
        cameraMover.onProperty().subscribe(_ -> updatePrompt());
        placer.promptProperty().subscribe(hint -> {
            onPick = hint.isEmpty() ? onPick : null;
            updatePrompt();
        });
        picturePart.regionRequestProperty().subscribe(_ -> updatePrompt());
        tracedPicture.renderStateProperty().map(RenderState::frame).subscribe(this::followFrame);
        picture.sceneProperty().subscribe(scene -> {
            if (scene != null) {
                scene.addEventFilter(KeyEvent.KEY_PRESSED, this::handleKey);
                scene.addEventFilter(KeyEvent.ANY, this::handleSpace);
            }
        });
    }

    /** While the space bar is held over the picture, the left button pans. */
    private void handleSpace(KeyEvent e) {
        if (e.getCode() != KeyCode.SPACE) {
            return;
        }
        boolean isPressed = e.getEventType() == KeyEvent.KEY_PRESSED && picture.isHover()
                && !(picture.getScene().getFocusOwner() instanceof Control);
        if (isPressed != isPanning) {
            isPanning = isPressed;
            updatePrompt();
        }
        if (isPressed) {
            e.consume();
        }
    }

    private void handleKey(KeyEvent e) {
        if (e.getCode() == KeyCode.CONTEXT_MENU || e.getCode() == KeyCode.F10 && e.isShiftDown()) {
            PicturePointer.Pixel pixel = picturePart.pixelProperty().get();
            if (pixel != null && !(picture.getScene().getFocusOwner() instanceof TextInputControl)) {
                Bounds bounds = picture.pictureBoundsProperty().getValue();
                double scale = bounds.getWidth() / requireNonNull(tracedPicture.frame()).scene().picture().width();
                Point2D at = picture.localToScreen(bounds.getMinX() + (pixel.x() + 0.5) * scale,
                        bounds.getMinY() + (pixel.y() + 0.5) * scale);
                showMenu(new PictureView.Pixel(pixel.x(), pixel.y()), at.getX(), at.getY());
                e.consume();
            }
            return;
        }
        if (e.getCode() != KeyCode.ESCAPE) {
            return;
        }
        if (gizmo.isDragging() || placer.isDragging() || cameraMover.isDragging()) {
            isCanceled = true;
            cancelDrag();
            e.consume();
        } else if (placer.clearRing()) {
            gizmo.draw();
            e.consume();
        } else if (!prompt.get().isEmpty()) {
            regionMode.set(false);
            cameraMover.switchOff();
            picturePart.regionRequestProperty().set(null);
            endPick();
            e.consume();
        }
    }

    private void cancelDrag() {
        if (cameraMover.isDragging()) {
            cameraMover.cancelDrag();
        } else if (gizmo.isDragging()) {
            gizmo.cancelDrag();
        } else {
            placer.cancelDrag();
            gizmo.draw();
        }
    }

    /** The next click reports its pixel instead of selecting a light; a right click cancels this. */
    void pickNext(String hint, Consumer<PixelReport> listener) {
        placer.clearTool();
        onPick = listener;
        pickHint = hint;
        updatePrompt();
    }

    /** Returns the instructions to show over the picture; empty if there are none. */
    ReadOnlyStringProperty promptProperty() {
        return prompt.getReadOnlyProperty();
    }

    /** Returns the overlay of the picture. */
    Node overlay() {
        return overlay;
    }

    /** Returns the scene of the last traced region; null before the first. */
    @Nullable
    Scene patchedScene() {
        return patchedScene;
    }

    /** Returns the region mode, in which a drag frames a region. */
    BooleanProperty regionProperty() {
        return regionMode;
    }

    private void updatePrompt() {
        PicturePointer.RegionRequest request = picturePart.regionRequestProperty().get();
        String placerPrompt = placer.promptProperty().get();
        prompt.set(onPick != null ? pickHint : !placerPrompt.isEmpty() ? Messages.tr("{0} (Shift snaps)", placerPrompt)
                : regionMode.get() ? Messages.tr("Drag a rectangle around the region to render")
                : request != null ? request.hint() : cameraMover.prompt());
        picture.setCursor(isPanning ? Cursor.OPEN_HAND : prompt.get().isEmpty() ? Cursor.DEFAULT : Cursor.CROSSHAIR);
    }

    private void hover(MouseEvent e) {
        Frame frame = tracedPicture.frame();
        if (frame == null) {
            return;
        }
        PictureSettings size = frame.scene().picture();
        picture.pixel(e.getX(), e.getY()).filter(p -> p.x() < size.width() && p.y() < size.height())
                .ifPresentOrElse(p -> hoverPixel(frame, p), this::clearHover);
    }

    /** Inspects the pixel under the pointer again in a new picture. */
    private void followFrame(@Nullable Frame frame) {
        PicturePointer.Pixel pixel = picturePart.pixelProperty().get();
        if (frame != null && pixel != null && picture.isHover()) {
            PictureSettings size = frame.scene().picture();
            if (pixel.x() < size.width() && pixel.y() < size.height()) {
                hoverPixel(frame, new PictureView.Pixel(pixel.x(), pixel.y()));
            }
        }
    }

    private void hoverPixel(Frame frame, PictureView.Pixel p) {
        picturePart.pixelProperty().set(new PicturePointer.Pixel(p.x(), p.y()));
        inspector.request(frame, p.x(), p.y(), report -> {
            if (picture.isHover()) {
                onHover.accept(report);
            }
        });
    }

    private void clearHover() {
        picturePart.pixelProperty().set(null);
        onHover.accept(null);
    }

    private void handlePress(MouseEvent e) {
        menu.hide();
        isCanceled = false;
        pressX = e.getX();
        pressY = e.getY();
        lastX = pressX;
        lastY = pressY;
        boolean movesCamera = isMovingCamera() && cameraMover.press(e);
        viewDrag = movesCamera ? null : viewDrag(e);
        if (movesCamera || viewDrag != null) {
            return;
        }
        boolean primary = e.getButton() == MouseButton.PRIMARY && !e.isAltDown() && !isPanning;
        boolean isPlacing = onPick == null && !placer.promptProperty().get().isEmpty();
        boolean isFree = prompt.get().isEmpty() && !isPanning && !picture.wipe().isVisible();
        boolean placerTook = primary && (isPlacing || isFree) && placer.press(pointer(e), TracedGizmo.TOLERANCE);
        if (isFree && !placerTook) {
            gizmo.press(e);
        }
    }

    /** Returns whether drags move the camera: its toggle is on, and no other tool waits for a click or a rectangle. */
    private boolean isMovingCamera() {
        return !isPanning && !prompt.get().isEmpty() && prompt.get().equals(cameraMover.prompt());
    }

    /** Returns how a press moves the image as the user's camera navigation moves the view; null if it does not. */
    private @Nullable CameraDrag viewDrag(MouseEvent press) {
        CameraNavigation navigation = settings.navigationProperty().get();
        // Shift snaps drags in the traced picture.
        return navigation.movesView(press) ? navigation.action(press).orElse(null) : null;
    }

    private LightPlacer.Pointer pointer(MouseEvent e) {
        return new LightPlacer.Pointer(picture.pixel(e.getX(), e.getY()), gizmo.viewport(), gizmo.toCanvas(e));
    }

    private void handleDrag(MouseEvent e) {
        if (isCanceled) {
            return;
        }
        if (cameraMover.isDragging()) {
            cameraMover.drag(e.getX() - pressX, e.getY() - pressY, gizmo.viewport());
            return;
        }
        if (viewDrag != null) {
            if (viewDrag == CameraDrag.ZOOM) {
                picture.zoomBy(Math.exp((lastY - e.getY()) / ZOOM_PIXELS), pressX, pressY);
            } else {
                picture.pan(e.getX() - lastX, e.getY() - lastY);
            }
            lastX = e.getX();
            lastY = e.getY();
            return;
        }
        hover(e);
        if (gizmo.isDragging()) {
            gizmo.drag(e);
            return;
        }
        if (placer.isDragging()) {
            placer.drag(pointer(e), e.isShiftDown());
            gizmo.draw();
            return;
        }
        if (e.getButton() == MouseButton.MIDDLE || e.isAltDown() || isPanning) {
            picture.pan(e.getX() - lastX, e.getY() - lastY);
        } else if ((regionMode.get() || picturePart.regionRequestProperty().get() != null) && !picture.isEmpty()) {
            regionFrame.setX(Math.min(pressX, e.getX()));
            regionFrame.setY(Math.min(pressY, e.getY()));
            regionFrame.setWidth(Math.abs(e.getX() - pressX));
            regionFrame.setHeight(Math.abs(e.getY() - pressY));
            regionFrame.setVisible(true);
        } else if (picture.wipe().isVisible()) {
            picture.wipeTo(e.getX());
        }
        lastX = e.getX();
        lastY = e.getY();
    }

    private void handleRelease(MouseEvent e) {
        boolean movedCamera = cameraMover.isDragging() && !e.isStillSincePress();
        cameraMover.release();
        if (movedCamera) {
            return;
        }
        if (viewDrag != null) {
            viewDrag = null;
            return;
        }
        boolean wasDragged = gizmo.isDragging() && !e.isStillSincePress();
        gizmo.release();
        if (placer.isDragging()) {
            placer.release(e.isStillSincePress());
            gizmo.draw();
            return;
        }
        if (wasDragged || isCanceled) {
            return;
        }
        if (isPanning && e.getButton() == MouseButton.PRIMARY) {
            return;
        }
        if (regionFrame.isVisible()) {
            regionFrame.setVisible(false);
            finishRegion(picture.nearestPixel(pressX, pressY), picture.nearestPixel(e.getX(), e.getY()));
        } else if (e.getButton() == MouseButton.SECONDARY && (onPick != null || !placer.promptProperty().get().isEmpty())) {
            endPick();
        } else if (e.isStillSincePress() && e.getButton() == MouseButton.PRIMARY && placer.promptProperty().get().isEmpty()) {
            click(e);
        } else if (e.isStillSincePress() && e.getButton() == MouseButton.SECONDARY) {
            picture.pixel(e.getX(), e.getY()).ifPresent(p -> showMenu(p, e.getScreenX(), e.getScreenY()));
        }
    }

    private void showMenu(PictureView.Pixel pixel, double screenX, double screenY) {
        Frame frame = tracedPicture.frame();
        if (frame == null) {
            editor.message().show(Messages.tr("The menu opens once the first picture is finished"));
        } else {
            clickInspector.request(frame, pixel.x(), pixel.y(),
                    report -> menu.show(picture, new PixelMenu.Target(frame, report, gizmo.viewport()), screenX, screenY));
        }
    }

    private void finishRegion(PictureView.Pixel from, PictureView.Pixel to) {
        PicturePointer.RegionRequest request = picturePart.regionRequestProperty().get();
        if (regionMode.get()) {
            traceRegion(from, to);
            regionMode.set(false);
        } else if (request != null) {
            picturePart.regionRequestProperty().set(null);
            request.onPicked().accept(new LightContributions.Region(Math.min(from.x(), to.x()), Math.min(from.y(), to.y()),
                    Math.max(from.x(), to.x()) + 1, Math.max(from.y(), to.y()) + 1));
        }
    }

    private void traceRegion(PictureView.Pixel from, PictureView.Pixel to) {
        var region = TracedRaster.DirtyRect.NONE.plus(from.x(), from.y(), from.x() + 1, from.y() + 1)
                .plus(to.x(), to.y(), to.x() + 1, to.y() + 1);
        TracedRaster.Pixels pixels = requireNonNull(tracedPicture.raster().pixels());
        Scene scene = editor.scene().withPicture(editor.scene().picture().withSize(pixels.width(), pixels.height()));
        Frame lastFrame = tracedPicture.frame();
        Function<Scene, Geometry> geometry =
                lastFrame == null ? Geometry::of : s -> lastFrame.geometry().forScene(s, lastFrame.geometry().castsReflections());
        regionTracer.trace(scene, geometry, region, film -> {
            tracedPicture.raster().patch(film, region);
            patchedScene = scene;
            windowExecutor.execute(tracedPicture::repaint);
        }, problem -> windowExecutor.execute(() -> editor.message().show(ErrorMessage.of(problem))));
    }

    private void click(MouseEvent e) {
        Frame frame = tracedPicture.frame();
        if (frame == null) {
            return;
        }
        picture.pixel(e.getX(), e.getY()).ifPresent(p -> clickInspector.request(frame, p.x(), p.y(), report -> {
            if (onPick == null) {
                select(report, e.getClickCount() > 1);
            } else if (report.point() == null) {
                editor.message().show(Messages.tr("No object here"));
            } else {
                Consumer<PixelReport> listener = onPick;
                endPick();
                listener.accept(report);
            }
        }));
    }

    /** Selects the light that contributes most, or what is seen: the face of a light, or an object. */
    private void select(PixelReport report, boolean isLight) {
        if (isLight || !report.face().isEmpty()) {
            report.strongest().ifPresent(editor.selection()::selectLight);
        } else if (!report.shape().isEmpty()) {
            editor.selection().selectNode(report.shape());
        }
    }

    /** Gives a material to the shape at a point of the picture's node. */
    void dropMaterial(MaterialSelection materials, Material material, double x, double y) {
        Frame frame = tracedPicture.frame();
        if (frame == null) {
            editor.message().show(Messages.tr("Materials can be dropped here once the first picture is finished"));
            return;
        }
        picture.pixel(x, y).ifPresent(p -> clickInspector.request(frame, p.x(), p.y(), report -> {
            if (report.shape().isEmpty()) {
                editor.message().show(Messages.tr("No object here"));
            } else {
                MaterialDrop.apply(editor, materials, report.shape(), material);
            }
        }));
    }

    private void endPick() {
        onPick = null;
        placer.clearTool();
        updatePrompt();
    }

    @Override
    public void close() {
        inspector.close();
        clickInspector.close();
        regionTracer.close();
    }
}
