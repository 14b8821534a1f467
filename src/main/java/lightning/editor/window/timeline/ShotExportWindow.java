package lightning.editor.window.timeline;

import javafx.stage.Window;
import lightning.editor.Command;
import lightning.editor.window.command.CommandKeys;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.PanelWindow;

/** Dialog for exporting the shot. */
public final class ShotExportWindow extends PanelWindow {
    private static final double WIDTH = 460;
    private static final double HEIGHT = 260;

    /** Creates the window. The scene must have a shot. */
    public ShotExportWindow(EditorModel model, Window owner) {
        this(model.commands(), owner, new ShotExportPane(model.editor(), model.files(), model.picture().outputViewProperty(),
                PathPrompt.ofSystem(owner, model.fileImporter().folder())));
    }

    private ShotExportWindow(CommandRegistry commands, Window owner, ShotExportPane pane) {
        super(owner, Command.EXPORT_SHOT.plainTitle(), pane, WIDTH, HEIGHT);
        CommandKeys.install(getScene(), commands);
        setOnHidden(_ -> pane.cancelExport());
    }
}
