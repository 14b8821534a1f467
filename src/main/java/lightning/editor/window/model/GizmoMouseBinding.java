package lightning.editor.window.model;

import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.document.manipulation.LightDrag;

/** Mouse bindings for dragging light gizmos in the preview and the traced picture. */
public final class GizmoMouseBinding {
    private GizmoMouseBinding() {}

    /**
     * Returns the drag for a mouse press.
     *
     * <p>Left rotates, Ctrl+left orbits the target, right translates across the view. The middle button, or any button with Alt, dollies.
     */
    public static LightDrag lightDrag(MouseEvent press) {
        if (press.isAltDown() || press.getButton() == MouseButton.MIDDLE) {
            return LightDrag.DOLLY;
        }
        return press.getButton() == MouseButton.SECONDARY ? LightDrag.TRANSLATE
                : press.isShortcutDown() ? LightDrag.ORBIT : LightDrag.ROTATE;
    }
}
