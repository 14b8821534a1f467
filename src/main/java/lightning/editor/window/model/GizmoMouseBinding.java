package lightning.editor.window.model;

import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.editor.document.LightDrag;

/** What the mouse does with the gizmo that it presses, in either picture. */
public final class GizmoMouseBinding {
    private GizmoMouseBinding() {}

    /** Left turns, with Ctrl it carries about the aim; right moves across the view; middle, or any with Alt, moves along it. */
    public static LightDrag lightDrag(MouseEvent press) {
        if (press.isAltDown() || press.getButton() == MouseButton.MIDDLE) {
            return LightDrag.DOLLY;
        }
        return press.getButton() == MouseButton.SECONDARY ? LightDrag.TRANSLATE
                : press.isShortcutDown() ? LightDrag.ORBIT : LightDrag.ROTATE;
    }
}
