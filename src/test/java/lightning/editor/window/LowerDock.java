package lightning.editor.window;

import lightning.editor.Command;
import lightning.editor.window.dock.DockSlot;
import lightning.editor.window.model.WindowLayout;

/** Default height of the dock below the pictures. */
public final class LowerDock {
    private LowerDock() {}

    /**
     * Returns the height with an open mixer.
     *
     * @param total height of pictures and dock, pixels
     */
    public static double defaultHeight(double total) {
        var arrangement = new WindowLayout();
        arrangement.panelsProperty().set(arrangement.panelsProperty().get().open(Command.MIXER));
        return DockSlot.size(total, 0, EditorLayout.lowerDockHeight(arrangement, total));
    }
}
