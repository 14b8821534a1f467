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
import lightning.base.text.Messages;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.document.manipulation.GroupBounds;
import lightning.document.manipulation.LightGizmo;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.editor.EditorState;
import lightning.editor.window.command.MaterialDrop;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.CameraNavigation;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.GizmoMouseBinding;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.CanvasSize;
import lightning.editor.window.widget.PixelImage;
import lightning.render.image.Film;
import lightning.scene.Scene;
import lightning.scene.VisibleState;
import lightning.scene.effects.PreviewScene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import org.jspecify.annotations.Nullable;

/** Canvas of the preview with the lights' wireframes on top; handles mouse and keyboard. */
public final class PreviewCanvas extends Region implements AutoCloseable {
    /** Time without a movement after which the camera counts as resting. */
    private static final Duration REST_DELAY = Duration.millis(120);
    /** Zoom drag that corresponds to a wheel movement, pixels per unit. */
    private static final double WHEEL_FACTOR = 0.5;

    private final EditorModel model;
    private final SceneEditor editor;
    private final PreviewSettings settings;
    private final ObjectProperty<PreviewCamera> camera;
    private final ImageView image = new ImageView();
    private final GizmoLayer gizmos = new GizmoLayer();
    private final PreviewMouse mouse;
    private final ShapeMenu menu;
    private final ShapePicker shapes;
    private final PreviewLoop loop;
    private final PreviewScene previewScene = new PreviewScene();
    private final GroupBounds groupBox = new GroupBounds();
    private final AtomicReference<PreviewLoop.Picture> pendingPicture = new AtomicReference<>();
    private final PauseTransition restTimer = new PauseTransition(REST_DELAY);
    private final ObjectProperty<CanvasSize> size = new SimpleObjectProperty<>(CanvasSize.PICTURE_ASPECT);
    private boolean isCameraMoving;

    PreviewCanvas(EditorModel model) {
        this.model = model;
        editor = model.editor();
        settings = model.previewSettings();
        camera = settings.cameraProperty();
        mouse = new PreviewMouse(editor, settings);
        Executor windowExecutor = model.files().windowExecutor();
        menu = new ShapeMenu(editor, model.materials(), model.commands());
        shapes = new ShapePicker(editor, menu, camera, windowExecutor, this);
        loop = new PreviewLoop(this::queuePicture,
                problem -> windowExecutor.execute(() -> editor.message().show(ErrorMessage.of(problem))));
        setId("preview-canvas");
        setFocusTraversable(true);
        setAccessibleRole(AccessibleRole.IMAGE_VIEW);
        setAccessibleText(Messages.tr("Preview of the scene and its lights"));
        getChildren().addAll(image, gizmos);
        editor.sceneProperty().subscribe(_ -> requestLayout());
        editor.selection().lightProperty().subscribe(_ -> requestLayout());
        editor.editorStateProperty().map(EditorState::selectedNode).subscribe(_ -> requestLayout());
        model.picture().viewProperty().subscribe(_ -> requestLayout());
        model.picture().renderStateProperty().map(RenderState::frame).subscribe(_ -> requestLayout());
        settings.shadowsProperty().subscribe(_ -> requestLayout());
        settings.glowingTexturesProperty().subscribe(_ -> requestLayout());
        settings.gizmosHiddenProperty().subscribe(_ -> requestLayout());
        settings.fogHandlesProperty().subscribe(_ -> requestLayout());
        settings.gizmoSizeProperty().subscribe(_ -> requestLayout());
        size.subscribe(_ -> requestLayout());
        camera.subscribe(_ -> {
            isCameraMoving = true;
            restTimer.playFromStart();
            requestLayout();
        });
        restTimer.setOnFinished(_ -> {
            isCameraMoving = false;
            requestLayout();
        });
        addHandlers();
    }

    /** Returns true while nothing has been drawn. */
    ObservableBooleanValue emptyProperty() {
        return image.imageProperty().isNull();
    }

    /** Gives a material to the shape at a point; does nothing if there is none. */
    public void dropMaterial(Material material, Viewport.Pixel point) {
        shapes.find(viewport(), point, shape -> MaterialDrop.apply(editor, model.materials(), shape, material));
    }

    /** Returns the resolution of the preview. */
    ObjectProperty<CanvasSize> sizeProperty() {
        return size;
    }

    private void addHandlers() {
        var keys = new PreviewKeys(editor, model.commands(), camera, mouse);
        addEventHandler(KeyEvent.KEY_PRESSED, keys::handlePress);
        addEventHandler(KeyEvent.KEY_RELEASED, _ -> keys.handleRelease());
        addEventHandler(MouseEvent.MOUSE_PRESSED, e -> {
            requestFocus();
            menu.hide();
            CameraNavigation navigation = settings.navigationProperty().get();
            if (navigation.movesView(e)) {
                mouse.pressForCamera(e.getX() - left(), e.getY() - top(), navigation.action(e));
            } else {
                mouse.press(e.getX() - left(), e.getY() - top(), GizmoMouseBinding.lightDrag(e));
            }
        });
        MaterialDrop.accept(this, (material, e) -> dropMaterial(material, new Viewport.Pixel(e.getX() - left(), e.getY() - top())));
        addEventHandler(ScrollEvent.SCROLL, e -> {
            if (e.getDeltaY() != 0) {
                camera.set(camera.get().zoom(e.getDeltaY() * WHEEL_FACTOR, viewport()));
                e.consume();
            }
        });
        addEventHandler(MouseEvent.MOUSE_DRAGGED, e -> mouse.drag(e.getX() - left(), e.getY() - top()));
        addEventHandler(MouseEvent.MOUSE_RELEASED, e -> {
            mouse.release();
            var point = new Viewport.Pixel(e.getX() - left(), e.getY() - top());
            if (e.getButton() == MouseButton.PRIMARY && e.isStillSincePress() && !settings.navigationProperty().get().movesView(e)
                    && !settings.gizmosHiddenProperty().get() && !mouse.canGrab(point.x(), point.y())) {
                shapes.select(mouse.canvas(), point);
            }
            if (e.getButton() == MouseButton.SECONDARY && e.isStillSincePress() && !e.isAltDown()
                    && mouse.lightsAt(point.x(), point.y()).isEmpty()) {
                shapes.showMenu(mouse.canvas(), point, e.getScreenX(), e.getScreenY());
            }
        });
    }

    private double left() {
        return image.getLayoutX();
    }

    private double top() {
        return image.getLayoutY();
    }

    /** Moves the camera back until it shows all lights. */
    void frameLights() {
        camera.set(LightMarker.frameLights(LightGizmo.placed(editor.scene().lights()), camera.get(), mouse.canvas()));
    }

    /** Returns the screen position of a point of the canvas. */
    public Point2D toScreen(Viewport.Pixel point) {
        return gizmos.localToScreen(point.x(), point.y());
    }

    /** Returns the area of the canvas in this region, pixels. */
    public Viewport viewport() {
        return mouse.canvas();
    }

    /** Lays out the canvas and requests a new picture. */
    @Override
    protected void layoutChildren() {
        if (getWidth() < 1 || getHeight() < 1) {
            return;
        }
        double pixelScale = getScene() == null || getScene().getWindow() == null ? 1 : getScene().getWindow().getOutputScaleX();
        var frame = size.get().fit(getWidth(), getHeight(), editor.scene().picture(), pixelScale);
        image.setFitWidth(frame.shownWidth());
        image.setFitHeight(frame.shownHeight());
        image.relocate(Math.rint((getWidth() - frame.shownWidth()) / 2), Math.rint((getHeight() - frame.shownHeight()) / 2));
        gizmos.resize(frame.shownWidth(), frame.shownHeight());
        gizmos.relocate(left(), top());
        mouse.setCanvas(new Viewport(frame.shownWidth(), frame.shownHeight()));
        gizmos.setVisible(!settings.gizmosHiddenProperty().get());
        List<LightGizmo.Stroke> group =
                editor.selection().node().filter(NodeGroup.class::isInstance).map(NodeGroup.class::cast).map(g -> GroupBounds
                        .strokes(groupBox.lines(editor.scene(), g), camera.get(), mouse.canvas())).orElse(List.of());
        gizmos.draw(editor.scene(), editor.selection().light(), new GizmoLayer.Marks(group, mouse.handles()), camera.get(),
                mouse.canvas(), settings.gizmoSizeProperty().get().factor());
        Scene scene = editor.scene();
        PreviewScene.Request request = previewScene.request(scene, editor.selection().lightName(),
                settings.glowingTexturesProperty().get() ? ViewEffects.PREVIEW_1998 : ViewEffects.PREVIEW,
                settings.shadowsProperty().get());
        loop.draw(new PreviewLoop.Request(request.scene(), camera.get(), frame.width(), frame.height(),
                model.picture().viewProperty().get().forOutput(),
                request.effects(), isCameraMoving,
                model.picture().frame() == null ? null : model.picture().frame().geometry(), comparableFilm(scene)));
    }

    /** Returns the traced picture if it shows the same scene through the same camera; otherwise null. */
    private @Nullable Film comparableFilm(Scene scene) {
        Frame frame = model.picture().frame();
        return frame != null && VisibleState.isSame(frame.scene(), scene)
                && camera.get().camera().equals(PreviewCamera.of(scene).camera()) ? frame.film() : null;
    }

    private boolean showsShadows() {
        return settings.shadowsProperty().get();
    }

    /** Returns what the preview shows: its camera, which shadows, and that it lacks fog. */
    String caption() {
        String view = camera.get().equals(PreviewCamera.of(editor.scene())) ? Messages.tr("Scene camera") : Messages.tr("Free view");
        String light = editor.selection().lightName();
        String shadows = showsShadows() && !light.isEmpty() ? Messages.tr("only shadows of {0}", light) : Messages.tr("no shadows");
        return view + " · " + shadows + (editor.scene().world().fog().isPresent() ? " · " + Messages.tr("no fog") : "");
    }

    private void queuePicture(PreviewLoop.Picture picture) {
        if (pendingPicture.getAndSet(picture) == null) {
            model.files().windowExecutor().execute(this::showPicture);
        }
    }

    private void showPicture() {
        PreviewLoop.Picture picture = pendingPicture.getAndSet(null);
        image.setImage(PixelImage.of(picture.width(), picture.height(), picture.pixels()));
        settings.framesProperty().set(settings.framesProperty().get() + 1);
    }

    @Override
    public void close() {
        loop.close();
    }
}
