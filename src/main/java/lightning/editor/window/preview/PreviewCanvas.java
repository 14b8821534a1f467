package lightning.editor.window.preview;

import java.util.List;
import java.util.concurrent.Executor;
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
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Situation;
import lightning.editor.document.Viewport;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Grip;
import lightning.editor.window.model.PreviewLook;
import lightning.editor.window.model.SceneEditor;
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
    private final SceneEditor editor;
    private final PreviewLook settings;
    private final ObjectProperty<PreviewCamera> camera;
    private final ImageView image = new ImageView();
    private final GizmoLayer gizmos = new GizmoLayer();
    private final PreviewMouse mouse;
    private final ShapeMenu menu;
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
        editor = model.editor();
        settings = model.previewLook();
        camera = settings.cameraProperty();
        mouse = new PreviewMouse(editor, settings);
        Executor window = model.files().window();
        menu = new ShapeMenu(editor, model.materials(), model.commands());
        shapes = new PreviewShapes(editor, menu, camera, window, this);
        loop = new PreviewLoop(this::drawn, problem -> window.execute(() -> editor.message().show(Sentence.of(problem))));
        setId("preview-canvas");
        setFocusTraversable(true);
        setAccessibleRole(AccessibleRole.IMAGE_VIEW);
        setAccessibleText(Texts.of("Preview of the scene with its lights"));
        getChildren().addAll(image, gizmos);
        editor.documentProperty().subscribe(_ -> opened = true);
        editor.sceneProperty().subscribe(_ -> requestLayout());
        editor.selection().lightProperty().subscribe(_ -> requestLayout());
        editor.situationProperty().map(Situation::node).subscribe(_ -> requestLayout());
        model.picture().viewProperty().subscribe(_ -> requestLayout());
        settings.glowingProperty().subscribe(_ -> requestLayout());
        settings.gizmosHiddenProperty().subscribe(_ -> requestLayout());
        settings.sizeProperty().subscribe(_ -> requestLayout());
        size.subscribe(_ -> requestLayout());
        camera.subscribe(_ -> {
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
        var keys = new PreviewKeys(editor, model.commands(), camera, mouse);
        addEventHandler(KeyEvent.KEY_PRESSED, keys::pressed);
        addEventHandler(KeyEvent.KEY_RELEASED, _ -> keys.released());
        addEventHandler(MouseEvent.MOUSE_PRESSED, e -> {
            requestFocus();
            menu.hide();
            mouse.press(e.getX() - left(), e.getY() - top(), Grip.of(e), e.isShiftDown());
        });
        addEventHandler(ScrollEvent.SCROLL, e -> {
            if (e.getDeltaY() != 0) {
                camera.set(camera.get().zoomed(e.getDeltaY() * WHEEL, viewport()));
                e.consume();
            }
        });
        addEventHandler(MouseEvent.MOUSE_DRAGGED, e -> mouse.drag(e.getX() - left(), e.getY() - top()));
        addEventHandler(MouseEvent.MOUSE_RELEASED, e -> {
            mouse.release();
            var place = new Viewport.Pixel(e.getX() - left(), e.getY() - top());
            if (e.getButton() == MouseButton.PRIMARY && e.isStillSincePress() && !e.isShiftDown()
                    && !settings.gizmosHiddenProperty().get() && !mouse.takes(place.x(), place.y())) {
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
        camera.set(LightMarker.framing(editor.scene().lights(), camera.get(), mouse.canvas()));
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
        var frame = size.get().within(getWidth(), getHeight(), editor.scene().picture(), screen);
        image.setFitWidth(frame.shownWidth());
        image.setFitHeight(frame.shownHeight());
        image.relocate(Math.rint((getWidth() - frame.shownWidth()) / 2), Math.rint((getHeight() - frame.shownHeight()) / 2));
        gizmos.resize(frame.shownWidth(), frame.shownHeight());
        gizmos.relocate(left(), top());
        mouse.setCanvas(new Viewport(frame.shownWidth(), frame.shownHeight()));
        if (opened) {
            opened = false;
            camera.set(
                    LightMarker.firstView(editor.scene().lights(), camera.get(), mouse.canvas()));
        }
        gizmos.setVisible(!settings.gizmosHiddenProperty().get());
        List<LightGizmo.Stroke> group = editor.selection().node().filter(Group.class::isInstance).map(Group.class::cast).map(g -> GroupBox
                .strokes(box.lines(editor.scene(), g), camera.get(), mouse.canvas())).orElse(List.of());
        gizmos.draw(editor.scene(), editor.selection().light(), new GizmoLayer.Marks(group, mouse.handles()), camera.get(),
                mouse.canvas(), settings.sizeProperty().get().factor());
        loop.draw(new PreviewLoop.Wish(look.of(editor.scene()), camera.get(), frame.width(), frame.height(),
                model.picture().viewProperty().get().ofPicture(),
                settings.glowingProperty().get() ? ViewEffects.PREVIEW_1998 : ViewEffects.PREVIEW,
                moving, model.picture().frame() == null ? null : model.picture().frame().geometry()));
    }

    private void drawn(PreviewLoop.Picture picture) {
        if (drawn.getAndSet(picture) == null) {
            model.files().window().execute(this::show);
        }
    }

    private void show() {
        PreviewLoop.Picture picture = drawn.getAndSet(null);
        image.setImage(PixelImage.of(picture.width(), picture.height(), picture.pixels()));
        settings.framesProperty().set(settings.framesProperty().get() + 1);
    }

    @Override
    public void close() {
        loop.close();
    }
}
