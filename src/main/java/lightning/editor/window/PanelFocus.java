package lightning.editor.window;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.dock.DockTabs;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.widget.PanelWindow;

/**
 * Moves the keyboard focus between the pictures, lists and panels of the editor, and its panels in windows of their own.
 *
 * @param editor returns the editor's window
 * @param areas parts of the editor's window, in order; those not shown are skipped
 */
record PanelFocus(Supplier<Window> editor, List<Node> areas) {
    void registerCommands(CommandRegistry commands) {
        commands.setAction(Command.NEXT_PANEL, () -> step(1));
        commands.setAction(Command.PREVIOUS_PANEL, () -> step(-1));
    }

    private void step(int direction) {
        List<Node> targets = Stream.concat(areas.stream().filter(a -> a.getScene() != null),
                Window.getWindows().stream().filter(w -> w instanceof PanelWindow p && p.getOwner() == editor.get())
                        .map(w -> w.getScene().getRoot()))
                .toList();
        int now = targets.indexOf(targets.stream().filter(PanelFocus::hasFocus).findFirst().orElse(null));
        for (int i = 1; i <= targets.size(); i++) {
            Node target = targets.get(Math.floorMod((now < 0 && direction < 0 ? 0 : now) + direction * i, targets.size()));
            Optional<Node> control = DockTabs.firstFocusable(target);
            if (control.isPresent()) {
                target.getScene().getWindow().requestFocus();
                control.get().requestFocus();
                return;
            }
        }
    }

    private static boolean hasFocus(Node area) {
        Node owner = area.getScene().getWindow().isFocused() ? area.getScene().getFocusOwner() : null;
        while (owner != null && owner != area) {
            owner = owner.getParent();
        }
        return owner != null;
    }
}
