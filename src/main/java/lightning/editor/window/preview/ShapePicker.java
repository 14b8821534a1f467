package lightning.editor.window.preview;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.scene.Node;
import lightning.document.loop.Frame;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.ScenePicker;
import lightning.document.manipulation.Viewport;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Finds the shape under the mouse in the preview on a background thread, and opens its menu or selects it. */
final class ShapePicker {
    private final SceneEditor editor;
    private final ObjectProperty<PreviewCamera> camera;
    private final Executor windowExecutor;
    private final Node canvas;
    private final ShapeMenu menu;
    private volatile @Nullable ScenePicker picker;

    /**
     * Creates the picker.
     *
     * @param windowExecutor runs tasks in order on the window's thread
     */
    ShapePicker(SceneEditor editor, ShapeMenu menu, ObjectProperty<PreviewCamera> camera, Executor windowExecutor, Node canvas) {
        this.editor = editor;
        this.menu = menu;
        this.camera = camera;
        this.windowExecutor = windowExecutor;
        this.canvas = canvas;
    }

    /**
     * Opens the menu of the shape at a point; does nothing if there is none.
     *
     * @param x screen position, pixels
     * @param y screen position, pixels
     */
    void showMenu(Viewport viewport, Viewport.Pixel point, double x, double y) {
        find(viewport, point, shape -> menu.show(canvas, shape, x, y));
    }

    /** Selects the shape at a point, or the light whose face it is; does nothing if there is none. */
    void select(Viewport viewport, Viewport.Pixel point) {
        find(viewport, point, name -> {
            if (editor.scene().light(name).isPresent()) {
                editor.selection().selectLight(name);
            } else {
                editor.selection().selectNode(name);
            }
        });
    }

    /** Passes the shape at a point, or the light whose face it is, to a consumer on the window's thread; does nothing if there is none. */
    void find(Viewport viewport, Viewport.Pixel point, Consumer<String> onFound) {
        Scene scene = editor.scene();
        Frame frame = editor.editorStateProperty().get().frame().orElse(null);
        PreviewCamera view = camera.get();
        Thread.ofVirtual().name("lightning-pick").start(() -> {
            picker = frame != null && frame.geometry().canServe(scene) ? ScenePicker.of(scene, frame.geometry())
                    : picker == null ? new ScenePicker(scene) : picker.forScene(scene);
            picker.pick(view, viewport, point).ifPresent(hit -> windowExecutor.execute(() -> onFound.accept(hit.shape())));
        });
    }
}
