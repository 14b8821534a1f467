package lightning.editor.window.model;

import java.util.Optional;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.base.text.Messages;
import lightning.document.manipulation.CameraDrag;

/** Mouse buttons that move the view: those of Lightning, or of the program that the user comes from. */
public enum CameraNavigation {
    /** Shift and any button; the start of the drag decides what it does. */
    LIGHTNING(Messages.key("Lightning (Shift)"),
            Messages.key("Left drag: rotate · Ctrl: orbit · Middle or Alt: dolly · Right: move · Shift: camera")),
    /** Alt with left, middle or right, as in Maya and Houdini. */
    ALT(Messages.key("Maya, Houdini (Alt)"),
            Messages.key("Left drag: rotate · Ctrl: orbit · Middle: dolly · Right: move · Camera: Alt + left, middle, right")),
    /** The middle button, with Shift or Ctrl, as in Blender. */
    MIDDLE(Messages.key("Blender (Middle Button)"),
            Messages.key("Left drag: rotate · Ctrl: orbit · Alt: dolly · Right: move · Camera: middle, with Shift, with Ctrl"));

    private final String title;
    private final String hint;

    CameraNavigation(String title, String hint) {
        this.title = title;
        this.hint = hint;
    }

    /** Returns the mouse actions of the preview, for its footer. */
    public String hint() {
        return Messages.tr(hint);
    }

    /** Returns whether a press starts a drag of the view, whatever is under the pointer. */
    public boolean movesView(MouseEvent press) {
        return switch (this) {
            case LIGHTNING -> press.isShiftDown();
            case ALT -> press.isAltDown() || press.isShiftDown();
            case MIDDLE -> press.getButton() == MouseButton.MIDDLE || press.isShiftDown();
        };
    }

    /** Returns the action of a press that {@link #movesView}; empty if the drag's start and direction decide. */
    public Optional<CameraDrag> action(MouseEvent press) {
        return switch (this) {
            case LIGHTNING -> Optional.empty();
            case ALT -> !press.isAltDown() ? Optional.empty() : Optional.of(switch (press.getButton()) {
                case MIDDLE -> CameraDrag.PAN;
                case SECONDARY -> CameraDrag.ZOOM;
                default -> CameraDrag.ORBIT;
            });
            case MIDDLE -> press.getButton() != MouseButton.MIDDLE ? Optional.empty()
                    : Optional.of(press.isShiftDown() ? CameraDrag.PAN : press.isShortcutDown() ? CameraDrag.ZOOM : CameraDrag.ORBIT);
        };
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
