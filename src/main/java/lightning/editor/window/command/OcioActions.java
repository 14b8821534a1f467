package lightning.editor.window.command;

import java.nio.file.Path;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.editor.document.Command;
import lightning.editor.document.OpenDocument;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.format.jen.JenFile;
import lightning.format.ocio.OcioConfig;
import lightning.format.ocio.OcioReference;
import lightning.format.ocio.OcioView;
import lightning.render.image.CubeLut;

/** Command that shows the picture with a view of OpenColorIO, through a table that is made in the background. */
final class OcioActions {
    private final EditorModel model;
    private final FilePrompt prompt;
    private final EditorDialogs notices;
    private final Preferences preferences;

    private OcioActions(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.preferences = preferences;
    }

    /** Table of a view, and what is said about it. */
    private record Baked(CubeLut table, OcioView view) {}

    /** Registers the command. */
    static void register(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences) {
        model.commands().setAction(Command.OCIO_VIEW, new OcioActions(model, prompt, notices, preferences)::choose);
    }

    private void choose() {
        OpenDocument document = model.editor().document();
        var chooser = new OcioChooser(model.files(), ColorTableActions.lastView(preferences, System.getenv(OcioReference.VARIABLE)),
                () -> prompt.configToOpen(ParentFolder.of(document.proposedFile("config.ocio"))), !document.isUntitled());
        if (!notices.askOcioView(chooser) || chooser.config().isEmpty()) {
            return;
        }
        OcioConfig config = chooser.config().get();
        OcioConfig.Choice choice = chooser.choice();
        boolean isKept = chooser.keepsTable();
        model.files().runConcurrently(() -> bake(config, choice, isKept, document), baked -> {
            ColorTableActions.set(model, preferences, baked.table(),
                    new OcioReference(config.source(), config.display(choice) + "/" + config.view(choice)), isKept);
            String note = baked.view().facts().note();
            model.editor().message()
                    .show(Messages.tr("Shows {0}; error in steps of 8 bits: {1} on average, at most {2}", baked.view().title(),
                            rounded(baked.view().facts().meanError()), rounded(baked.view().facts().largestError()))
                            + (note.isEmpty() ? "" : "; " + note));
        }, failure -> notices.showFailure(Messages.tr("The OpenColorIO view could not be used"), failure));
    }

    private static Baked bake(OcioConfig config, OcioConfig.Choice choice, boolean isKept, OpenDocument document) throws Exception {
        OcioView view = OcioView.bake(config, choice, Progress.NONE);
        if (!isKept) {
            return new Baked(view.table(), view);
        }
        Path file = document.proposedFile(view.fileName(JenFile.stem(document.name())));
        view.write(file);
        return new Baked(view.table().withFile(file), view);
    }

    private static double rounded(double steps) {
        return Math.round(steps * 100) / 100.0;
    }
}
