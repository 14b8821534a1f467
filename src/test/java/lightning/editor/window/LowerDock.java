package lightning.editor.window;

import lightning.editor.window.dock.DockSlot;

/** Default height of the dock below the pictures. */
public final class LowerDock {
    private LowerDock() {}

    /** @param total height of pictures and dock, pixels */
    public static double defaultHeight(double total) {
        return DockSlot.size(total, 0, EditorLayout.lowerDockHeight(total));
    }
}
