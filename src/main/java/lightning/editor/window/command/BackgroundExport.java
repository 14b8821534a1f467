package lightning.editor.window.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.document.OpenDocument;
import lightning.editor.window.model.EditorModel;

/** Writes files of the picture on a thread of their own, one at a time, with progress in the status line. Esc cancels. */
record BackgroundExport(EditorModel model, EditorDialogs notices) {
    /** Writes a file; runs on its own thread. */
    @FunctionalInterface
    interface Writer {
        void write(Path file, Progress progress) throws IOException;
    }

    /**
     * Starts to write a file, which must not be one that the scene reads.
     *
     * @param failureTitle title of the dialog if it cannot be written
     */
    void start(Path file, String failureTitle, Writer writer) {
        String name = Quote.path(file.getFileName());
        model.fileActivity().beginWriting(file);
        OpenDocument document = model.editor().document();
        model.files().runConcurrently(() -> {
            document.inputs().check(file);
            writer.write(file,
                    new FileProgressMessage(file, model.fileActivity(), model.files().windowExecutor(), model.editor().message()));
            return file;
        }, _ -> end(file, Messages.tr("Exported {0}", name)), failure -> {
            end(file, failure instanceof CancellationException ? Messages.tr("Export of {0} canceled", name) : "");
            if (!(failure instanceof CancellationException)) {
                notices.showFailure(failureTitle, failure);
            }
        });
    }

    private void end(Path file, String text) {
        model.fileActivity().end(file);
        model.editor().message().show(text);
    }
}
