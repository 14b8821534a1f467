package lightning.editor.window.preview;

import java.util.function.Consumer;
import javafx.scene.Node;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.ScenePicker;
import lightning.editor.document.Viewport;
import lightning.editor.loop.Frame;
import lightning.editor.window.command.ShapeMenu;
import lightning.editor.window.model.EditorModel;
import lightning.scene.Scene;

/** Finds the shape under the mouse in the preview, beside the window's thread, and offers what to do with it. */
final class PreviewShapes {
    private final EditorModel model;
    private final Node canvas;
    private final ShapeMenu menu;
    private volatile ScenePicker picker;

    PreviewShapes(EditorModel model, Node canvas) {
        this.model = model;
        this.canvas = canvas;
        menu = new ShapeMenu(model);
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
        find(viewport, place, model::selectNode);
    }

    private void find(Viewport viewport, Viewport.Pixel place, Consumer<String> found) {
        Scene scene = model.scene();
        Frame shared = model.frame();
        PreviewCamera view = model.previewCameraProperty().get();
        Thread.ofVirtual().name("lightning-pick").start(() -> {
            picker = shared != null && shared.geometry().serves(scene) ? ScenePicker.of(scene, shared.geometry())
                    : picker == null ? new ScenePicker(scene) : picker.forScene(scene);
            picker.at(view, viewport, place).ifPresent(at -> model.window().execute(() -> found.accept(at.shape())));
        });
    }

    void hide() {
        menu.hide();
    }
}
