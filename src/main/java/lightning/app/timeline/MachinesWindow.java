package lightning.app.timeline;

import java.util.function.Consumer;
import javafx.stage.Window;
import lightning.app.command.CommandKeys;
import lightning.app.command.PathAsk;
import lightning.app.model.EditorModel;
import lightning.app.widget.PanelWindow;
import lightning.text.Texts;

/** Asks which other machines shall hold the frames. */
final class MachinesWindow extends PanelWindow {
    private static final double WIDTH = 480;
    private static final double HEIGHT = 250;

    private final MachinesPane pane;

    /** @param use gets the frames on them, once this machine takes part */
    MachinesWindow(EditorModel model, Window owner, Consumer<FramesElsewhere> use) {
        this(model, owner, new MachinesPane(model, PathAsk.inWindows(owner, model.document().file().toAbsolutePath().getParent())), use);
    }

    private MachinesWindow(EditorModel model, Window owner, MachinesPane pane, Consumer<FramesElsewhere> use) {
        super(owner, Texts.of("On Other Machines"), pane, WIDTH, HEIGHT);
        this.pane = pane;
        CommandKeys.take(getScene(), model);
        pane.whenJoined(frames -> {
            use.accept(frames);
            close();
        });
    }

    /** Nobody waits for machines any more. */
    void stop() {
        pane.stop();
    }
}
