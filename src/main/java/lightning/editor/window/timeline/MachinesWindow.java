package lightning.editor.window.timeline;

import java.util.function.Consumer;
import javafx.stage.Window;
import lightning.base.text.Messages;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.widget.PanelWindow;

/** Dialog for choosing the machines that render the film strip. */
final class MachinesWindow extends PanelWindow {
    private static final double WIDTH = 480;
    private static final double HEIGHT = 250;

    /**
     * Creates the window.
     *
     * @param onJoined receives the remote frames once this machine has joined
     */
    MachinesWindow(MachinesPane pane, Window owner, CommandRegistry commands, Consumer<RemoteFrames> onJoined) {
        super(owner, Messages.tr("Render on Other Machines"), pane, WIDTH, HEIGHT);
        CommandKeys.install(getScene(), commands);
        pane.setOnJoined(frames -> {
            onJoined.accept(frames);
            close();
        });
        setOnHidden(_ -> pane.cancel());
    }
}
