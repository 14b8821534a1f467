package lightning.editor.window.timeline;

import java.util.function.Consumer;
import javafx.stage.Window;
import lightning.base.text.Texts;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.PanelWindow;

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
