package lightning.editor.window.command;

import java.io.IOException;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.document.OpenDocument;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.format.jen.JenFile;
import lightning.format.ocio.OcioConfig;
import lightning.format.ocio.OcioReference;
import lightning.format.ocio.OcioView;

/** Command that shows the picture with a view of OpenColorIO, through a table that is made in the background. */
final class OcioActions {
    private final EditorModel model;
    private final FilePrompt prompt;
    private final EditorDialogs notices;
    private final Preferences preferences;
    /** Number of requested views; an earlier one that ends late is not shown. */
    private int requests;

    private OcioActions(EditorModel model, FilePrompt prompt, EditorDialogs notices, Preferences preferences) {
        this.model = model;
        this.prompt = prompt;
        this.notices = notices;
        this.preferences = preferences;
    }

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
        int request = ++requests;
        model.editor().message().show(Messages.tr("Making the LUT of {0}…", config.view(choice)));
        model.files().runConcurrently(() -> bake(config, choice, isKept, document), view -> {
            if (request == requests) {
                show(view, new OcioReference(config.source(), config.display(choice) + "/" + config.view(choice)), isKept);
            }
        }, failure -> notices.showFailure(Messages.tr("The OpenColorIO view could not be used"), failure));
    }

    private static OcioView bake(OcioConfig config, OcioConfig.Choice choice, boolean isKept, OpenDocument document) throws IOException {
        OcioView view = OcioView.bake(config, choice, Progress.NONE);
        return isKept ? view.write(document.proposedFile(view.fileName(JenFile.stem(document.name())))) : view;
    }

    private void show(OcioView view, OcioReference reference, boolean isKept) {
        ColorTableActions.set(model, preferences, view.table(), reference, isKept);
        OcioView.Facts facts = view.facts();
        model.editor().message().show(Messages.tr("Shows {0}; error in steps of 8 bits: {1} on average, at most {2}", view.title(),
                rounded(facts.meanError()), rounded(facts.largestError())) + (facts.note().isEmpty() ? "" : "; " + facts.note()));
    }

    private static double rounded(double steps) {
        return Math.round(steps * 100) / 100.0;
    }
}
