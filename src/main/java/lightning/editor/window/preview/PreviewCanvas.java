package lightning.editor.window.preview;

import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import javafx.animation.PauseTransition;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableBooleanValue;
import javafx.geometry.Point2D;
import javafx.scene.AccessibleRole;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Region;
import javafx.util.Duration;
import lightning.base.text.Texts;
import lightning.editor.document.GroupBox;
import lightning.editor.document.LightGizmo;
import lightning.editor.document.Situation;
import lightning.editor.document.Viewport;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Grip;
import lightning.editor.window.model.PreviewLook;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.CanvasSize;
import lightning.editor.window.widget.PixelImage;
import lightning.scene.Group;
import lightning.scene.effects.ViewEffects;

/** The drawn preview with the lights' wireframes over it; takes the mouse and the keyboard. */
public final class PreviewCanvas extends Region implements AutoCloseable {
    /** The camera rests when it did not move for so long. */
    private static final Duration REST = Duration.millis(120);
    /** What a turn of the wheel is as a drag that zooms. */
    private static final double WHEEL = 0.5;

    private final EditorModel model;
    private final ImageView image = new ImageView();
    private final GizmoLayer gizmos = new GizmoLayer();
    private final PreviewMouse mouse;
    private final PreviewShapes shapes;
    private final PreviewLoop loop;
    private final PreviewScene look = new PreviewScene();
    private final GroupBox box = new GroupBox();
    private final AtomicReference<PreviewLoop.Picture> drawn = new AtomicReference<>();
    private final PauseTransition rest = new PauseTransition(REST);
    private final ObjectProperty<CanvasSize> size = new SimpleObjectProperty<>(CanvasSize.LIKE_PICTURE);
    private boolean moving;
    /** Whether a scene was opened and is not laid out yet. */
    private boolean opened;

    PreviewCanvas(EditorModel model) {
        this.model = model;
        mouse = new PreviewMouse(model);
        shapes = new PreviewShapes(model, this);
        loop = new PreviewLoop(this::drawn, problem -> model.window().execute(() -> model.say(Sentence.of(problem))));
        setId("preview-canvas");
        setFocusTraversable(true);
        setAccessibleRole(AccessibleRole.IMAGE_VIEW);
        setAccessibleText(Texts.of("Preview of the scene with its lights"));
        getChildren().addAll(image, gizmos);
        model.documentProperty().subscribe(_ -> opened = true);
        model.sceneProperty().subscribe(_ -> requestLayout());
        model.selectedLightProperty().subscribe(_ -> requestLayout());
        model.situationProperty().map(Situation::node).subscribe(_ -> requestLayout());
        model.viewProperty().subscribe(_ -> requestLayout());
        PreviewLook settings = model.previewLook();
        settings.glowingProperty().subscribe(_ -> requestLayout());
        settings.gizmosHiddenProperty().subscribe(_ -> requestLayout());
        settings.sizeProperty().subscribe(_ -> requestLayout());
        size.subscribe(_ -> requestLayout());
        model.previewCameraProperty().subscribe(_ -> {
            moving = true;
            rest.playFromStart();
            requestLayout();
        });
        rest.setOnFinished(_ -> {
            moving = false;
            requestLayout();
        });
        listen();
    }

    /** Whether nothing is drawn yet. */
    ObservableBooleanValue emptyProperty() {
        return image.imageProperty().isNull();
    }

    /** How large the preview is drawn. */
    ObjectProperty<CanvasSize> sizeProperty() {
        return size;
    }

    private void listen() {
        var keys = new PreviewKeys(model, mouse);
        addEventHandler(KeyEvent.KEY_PRESSED, keys::pressed);
        addEventHandler(KeyEvent.KEY_RELEASED, _ -> keys.released());
        addEventHandler(MouseEvent.MOUSE_PRESSED, e -> {
            requestFocus();
            shapes.hide();
            mouse.press(e.getX() - left(), e.getY() - top(), Grip.of(e), e.isShiftDown());
        });
        addEventHandler(ScrollEvent.SCROLL, e -> {
            if (e.getDeltaY() != 0) {
                model.previewCameraProperty().set(model.previewCameraProperty().get().zoomed(e.getDeltaY() * WHEEL, viewport()));
                e.consume();
            }
        });
        addEventHandler(MouseEvent.MOUSE_DRAGGED, e -> mouse.drag(e.getX() - left(), e.getY() - top()));
        addEventHandler(MouseEvent.MOUSE_RELEASED, e -> {
            mouse.release();
            var place = new Viewport.Pixel(e.getX() - left(), e.getY() - top());
            if (e.getButton() == MouseButton.PRIMARY && e.isStillSincePress() && !e.isShiftDown()
                    && !model.previewLook().gizmosHiddenProperty().get() && !mouse.takes(place.x(), place.y())) {
                shapes.select(mouse.canvas(), place);
            }
            if (e.getButton() == MouseButton.SECONDARY && e.isStillSincePress() && mouse.lightsAt(place.x(), place.y()).isEmpty()) {
                shapes.offer(mouse.canvas(), place, e.getScreenX(), e.getScreenY());
            }
        });
    }

    private double left() {
        return image.getLayoutX();
    }

    private double top() {
        return image.getLayoutY();
    }

    /** Goes back with the camera until all lights are in view. */
    void frameLights() {
        model.previewCameraProperty().set(LightMarker.framing(model.lights(), model.previewCameraProperty().get(), mouse.canvas()));
    }

    /** Where a place of the canvas is on the screen. */
    public Point2D onScreen(Viewport.Pixel place) {
        return gizmos.localToScreen(place.x(), place.y());
    }

    /** The canvas in this region, pixels of the window. */
    public Viewport viewport() {
        return mouse.canvas();
    }

    /** Lays out, and wishes for a picture of what there is now. */
    @Override
    protected void layoutChildren() {
        if (getWidth() < 1 || getHeight() < 1) {
            return;
        }
        double screen = getScene() == null || getScene().getWindow() == null ? 1 : getScene().getWindow().getOutputScaleX();
        var frame = size.get().within(getWidth(), getHeight(), model.scene().picture(), screen);
        image.setFitWidth(frame.shownWidth());
        image.setFitHeight(frame.shownHeight());
        image.relocate(Math.rint((getWidth() - frame.shownWidth()) / 2), Math.rint((getHeight() - frame.shownHeight()) / 2));
        gizmos.resize(frame.shownWidth(), frame.shownHeight());
        gizmos.relocate(left(), top());
        mouse.setCanvas(new Viewport(frame.shownWidth(), frame.shownHeight()));
        if (opened) {
            opened = false;
            model.previewCameraProperty().set(
                    LightMarker.firstView(model.lights(), model.previewCameraProperty().get(), mouse.canvas()));
        }
        gizmos.setVisible(!model.previewLook().gizmosHiddenProperty().get());
        List<LightGizmo.Stroke> group = model.selectedNode().filter(Group.class::isInstance).map(Group.class::cast).map(g -> GroupBox
                .strokes(box.lines(model.scene(), g), model.previewCameraProperty().get(), mouse.canvas())).orElse(List.of());
        gizmos.draw(model.scene(), model.selectedLight(), new GizmoLayer.Marks(group, mouse.handles()), model.previewCameraProperty().get(),
                mouse.canvas(), model.previewLook().sizeProperty().get().factor());
        loop.draw(new PreviewLoop.Wish(look.of(model.scene()), model.previewCameraProperty().get(), frame.width(), frame.height(),
                model.viewProperty().get().ofPicture(),
                model.previewLook().glowingProperty().get() ? ViewEffects.PREVIEW_1998 : ViewEffects.PREVIEW,
                moving, model.frame() == null ? null : model.frame().geometry()));
    }

    private void drawn(PreviewLoop.Picture picture) {
        if (drawn.getAndSet(picture) == null) {
            model.window().execute(this::show);
        }
    }

    private void show() {
        PreviewLoop.Picture picture = drawn.getAndSet(null);
        image.setImage(PixelImage.of(picture.width(), picture.height(), picture.pixels()));
        model.previewFramesProperty().set(model.previewFramesProperty().get() + 1);
    }

    @Override
    public void close() {
        loop.close();
    }
}
