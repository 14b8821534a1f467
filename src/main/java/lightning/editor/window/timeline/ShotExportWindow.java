package lightning.editor.window.timeline;

import javafx.stage.Window;
import lightning.editor.document.Command;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.PathAsk;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.PanelWindow;

/** Asks what the shot shall be exported as. */
public final class ShotExportWindow extends PanelWindow {
    private static final double WIDTH = 460;
    private static final double HEIGHT = 260;

    /** The scene must have a shot. */
    public ShotExportWindow(EditorModel model, Window owner) {
        this(model.commands(), owner, new ShotExportPane(model.editor(), model.files(), model.picture().viewProperty(),
                PathAsk.inWindows(owner, model.bringer().folder())));
    }

    private ShotExportWindow(Commands commands, Window owner, ShotExportPane pane) {
        super(owner, Command.EXPORT_SHOT.plainTitle(), pane, WIDTH, HEIGHT);
        CommandKeys.take(getScene(), commands);
        setOnHidden(_ -> pane.stop());
    }
}
