package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.base.text.Messages;
import lightning.document.CameraEdits;
import lightning.document.EditOutcome;
import lightning.document.manipulation.CameraDrag;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.PreviewSettings;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Camera;
import org.jspecify.annotations.Nullable;

/** Toggle with which drags in the traced picture move the scene's camera. A drag is one step of undo. */
final class CameraMover {
    private final SceneEditor editor;
    private final PreviewSettings settings;
    private final BooleanProperty isOn = new SimpleBooleanProperty();
    /** View at the start of the current drag; null while there is none. */
    private @Nullable PreviewCamera start;
    private Camera before = Camera.DEFAULT;
    private CameraDrag action = CameraDrag.ORBIT;
    private Object gesture = new Object();

    private CameraMover(SceneEditor editor, PreviewSettings settings) {
        this.editor = editor;
        this.settings = settings;
    }

    /** Registers the toggle's command. */
    static CameraMover register(CommandRegistry commands, SceneEditor editor, PreviewSettings settings) {
        var mover = new CameraMover(editor, settings);
        commands.setToggle(Command.MOVE_CAMERA, mover.isOn);
        return mover;
    }

    ReadOnlyBooleanProperty onProperty() {
        return isOn;
    }

    void switchOff() {
        isOn.set(false);
        start = null;
    }

    /** Returns the instructions to show over the picture; empty while the toggle is off. */
    String prompt() {
        return isOn.get() ? Messages.tr("Camera: drag orbits · Shift or middle moves · Ctrl or right comes nearer") : "";
    }

    /** Starts a drag; returns false while the toggle is off. */
    boolean press(MouseEvent e) {
        if (!isOn.get()) {
            return false;
        }
        before = editor.scene().camera();
        start = CameraEdits.focused(editor.scene());
        gesture = new Object();
        action = navigated(e).orElse(e.getButton() == MouseButton.MIDDLE || e.isShiftDown() ? CameraDrag.PAN
                : e.getButton() == MouseButton.SECONDARY || e.isShortcutDown() ? CameraDrag.ZOOM : CameraDrag.ORBIT);
        return true;
    }

    private Optional<CameraDrag> navigated(MouseEvent e) {
        return settings.navigationProperty().get().movesView(e) ? settings.navigationProperty().get().action(e) : Optional.empty();
    }

    boolean isDragging() {
        return start != null;
    }

    /**
     * Moves the camera by the total movement of the drag.
     *
     * @param right pixels, with {@code down}
     */
    void drag(double right, double down, Viewport viewport) {
        PreviewCamera moved = action.apply(requireNonNull(start), viewport, right, down);
        editor.editAndRenderOrReport(scene -> CameraEdits.use(scene, moved), gesture);
    }

    /** Ends a drag. */
    void release() {
        start = null;
    }

    /** Ends a drag and moves the camera back. */
    void cancelDrag() {
        start = null;
        editor.editAndRenderOrReport(scene -> EditOutcome.of(() -> scene.withCamera(before)), gesture);
    }
}
