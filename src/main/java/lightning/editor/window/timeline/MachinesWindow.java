package lightning.editor.window.timeline;

import java.util.function.Consumer;
import javafx.stage.Window;
import lightning.base.text.Texts;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.model.Commands;
import lightning.editor.window.widget.PanelWindow;

/** Asks which other machines shall hold the frames. */
final class MachinesWindow extends PanelWindow {
    private static final double WIDTH = 480;
    private static final double HEIGHT = 250;

    /** @param use gets the frames on them, once this machine takes part */
    MachinesWindow(MachinesPane pane, Window owner, Commands commands, Consumer<FramesElsewhere> use) {
        super(owner, Texts.of("On Other Machines"), pane, WIDTH, HEIGHT);
        CommandKeys.take(getScene(), commands);
        pane.whenJoined(frames -> {
            use.accept(frames);
            close();
        });
        setOnHidden(_ -> pane.stop());
    }
}
