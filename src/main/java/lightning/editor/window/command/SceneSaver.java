package lightning.editor.window.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import javafx.scene.control.ButtonType;
import lightning.base.file.ChangedFileException;
import lightning.base.file.ReadOnlyFileException;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.OpenDocument;
import lightning.document.OverwriteConfirmation;
import lightning.document.TextDifference;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.StatusMessage;
import lightning.format.jen.JenFile;
import lightning.format.jen.asset.JenLimits;
import lightning.scene.shot.AnimatedScene;

/** Saves the scene, and confirms before overwriting changes that the user may not have seen. */
final class SceneSaver {
    private final EditorModel model;
    private final SceneEditor editor;
    private final StatusMessage message;
    private final FilePrompt prompt;
    private final EditorDialogs notices;
    private final Runnable saveListener;

    /** @param saveListener  runs after the scene was written */
    SceneSaver(EditorModel model, FilePrompt prompt, EditorDialogs notices, Runnable saveListener) {
        this.model = model;
        editor = model.editor();
        message = editor.message();
        this.prompt = prompt;
        this.notices = notices;
        this.saveListener = saveListener;
    }

    /** Saves to the document's file; prompts for one if the document is untitled. {@code onSaved} runs after the scene was written, there or to another file that the user chose. */
    void save(Runnable onSaved) {
        if (editor.document().isUntitled()) {
            saveAs(onSaved);
        } else {
            write(editor.document().file(), Set.of(), onSaved);
        }
    }

    /** Prompts for a file and saves to it. {@code onSaved} runs after the scene was written. */
    void saveAs(Runnable onSaved) {
        prompt.sceneToWrite(editor.document().proposedFile(editor.document().file().getFileName().toString())).ifPresent(
                chosen -> notices.withExtension(model.files(), chosen, JenFile.EXTENSION, file -> write(file, Set.of(), onSaved)));
    }

    private void write(Path file, Set<OverwriteConfirmation> allowed, Runnable onSaved) {
        message.show(Messages.tr("Saving {0} …", Quote.path(file.getFileName())));
        model.workbench().saveAs(file, allowed, failure -> {
            message.clear();
            failure.ifPresentOrElse(cause -> handleFailure(file, allowed, cause, onSaved), () -> {
                saveListener.run();
                onSaved.run();
            });
        });
    }

    private void handleFailure(Path file, Set<OverwriteConfirmation> allowed, Throwable failure, Runnable onSaved) {
        switch (failure) {
            case ChangedFileException _ -> resolveConflict(allowed, onSaved);
            case ReadOnlyFileException _ -> {
                ButtonType answer = notices.askReadOnly(file).orElse(ButtonType.CANCEL);
                if (answer == EditorDialogs.REPLACE) {
                    write(file, with(allowed, OverwriteConfirmation.REPLACE_READ_ONLY), onSaved);
                } else if (answer == EditorDialogs.SAVE_AS) {
                    saveAs(onSaved);
                }
            }
            case Throwable other -> {
                if (notices.askSaveAs(Messages.tr("The scene could not be saved"), other)) {
                    saveAs(onSaved);
                }
            }
        }
    }

    /** Shows the differences between the open scene and its file, and lets the user choose. */
    void resolveConflict() {
        resolveConflict(Set.of(), () -> {});
    }

    private void resolveConflict(Set<OverwriteConfirmation> allowed, Runnable onSaved) {
        OpenDocument document = editor.document();
        AnimatedScene mine = document.content();
        model.files().runConcurrently(() -> TextDifference.rows(document.text(mine), text(document.file())),
                rows -> handleAnswer(notices.askChangedFile(document.name(), new TextDifferenceView(rows)).orElse(ButtonType.CANCEL),
                        allowed, onSaved),
                failure -> notices.showFailure(Messages.tr("{0} could not be read", document.name()), failure));
    }

    private void handleAnswer(ButtonType answer, Set<OverwriteConfirmation> allowed, Runnable onSaved) {
        if (answer == EditorDialogs.OVERWRITE) {
            write(editor.document().file(), with(allowed, OverwriteConfirmation.OVERWRITE_CHANGED), onSaved);
        } else if (answer == EditorDialogs.RELOAD) {
            model.commands().run(Command.RELOAD);
        } else if (answer == EditorDialogs.SAVE_AS) {
            saveAs(onSaved);
        }
    }

    private static Set<OverwriteConfirmation> with(Set<OverwriteConfirmation> allowed, OverwriteConfirmation more) {
        Set<OverwriteConfirmation> all = EnumSet.of(more);
        all.addAll(allowed);
        return all;
    }

    private static String text(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            return "";
        }
        try (InputStream in = Files.newInputStream(file)) {
            return new String(in.readNBytes(JenLimits.FILE_BYTES), StandardCharsets.UTF_8);
        }
    }
}
