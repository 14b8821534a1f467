package lightning.editor.window.preview;

import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.scene.Node;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.ScenePicker;
import lightning.editor.document.Viewport;
import lightning.editor.loop.Frame;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;

/** Finds the shape under the mouse in the preview, beside the window's thread, and offers what to do with it. */
final class PreviewShapes {
    private final SceneEditor editor;
    private final ObjectProperty<PreviewCamera> camera;
    private final Executor window;
    private final Node canvas;
    private final ShapeMenu menu;
    private volatile ScenePicker picker;

    /** @param window runs tasks in turn on the window's thread */
    PreviewShapes(SceneEditor editor, ShapeMenu menu, ObjectProperty<PreviewCamera> camera, Executor window, Node canvas) {
        this.editor = editor;
        this.menu = menu;
        this.camera = camera;
        this.window = window;
        this.canvas = canvas;
    }

    /**
     * Opens the menu of the shape at a place; nothing where there is none.
     *
     * @param x of the screen, pixels; likewise {@code y}
     */
    void offer(Viewport viewport, Viewport.Pixel place, double x, double y) {
        find(viewport, place, shape -> menu.show(canvas, shape, x, y));
    }

    /** Selects the shape at a place; nothing where there is none. */
    void select(Viewport viewport, Viewport.Pixel place) {
        find(viewport, place, editor.selection()::selectNode);
    }

    private void find(Viewport viewport, Viewport.Pixel place, Consumer<String> found) {
        Scene scene = editor.scene();
        Frame shared = editor.situationProperty().get().frame().orElse(null);
        PreviewCamera view = camera.get();
        Thread.ofVirtual().name("lightning-pick").start(() -> {
            picker = shared != null && shared.geometry().serves(scene) ? ScenePicker.of(scene, shared.geometry())
                    : picker == null ? new ScenePicker(scene) : picker.forScene(scene);
            picker.at(view, viewport, place).ifPresent(at -> window.execute(() -> found.accept(at.shape())));
        });
    }
}
