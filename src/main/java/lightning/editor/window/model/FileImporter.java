package lightning.editor.window.model;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.FileThread;
import lightning.format.jen.asset.FileCopy;
import lightning.format.jen.asset.FileKind;
import org.jspecify.annotations.Nullable;

/** Copies external files to where the open scene finds them. Overwrites an existing file only if it is chosen twice. */
public final class FileImporter {
    private final SceneEditor editor;
    private final FileThread files;
    private BiFunction<String, FileKind, Optional<Path>> filePrompt = (_, _) -> Optional.empty();
    /** Last chosen file whose name is already in use. */
    private @Nullable Path rejectedFile;

    FileImporter(SceneEditor editor, FileThread files) {
        this.editor = editor;
        this.files = files;
    }

    /** Returns the folder of the open scene. */
    public Path folder() {
        return ParentFolder.of(editor.document().file());
    }

    /** Returns the thread that reads the scene's files. */
    public FileThread files() {
        return files;
    }

    /** Sets the prompt that chooses a file; it receives the prompt's title. */
    public void setFilePrompt(BiFunction<String, FileKind, Optional<Path>> prompt) {
        filePrompt = prompt;
    }

    /** Prompts for a file that stays where it is; empty if the user cancels. */
    public Optional<Path> prompt(String title, FileKind kind) {
        return filePrompt.apply(title, kind);
    }

    /**
     * Prompts for a file and imports it, unless the user cancels.
     *
     * @param title  title of the prompt
     * @param onImported  receives the name by which the scene finds the file
     * @param onRefused  receives the reason for a failed import
     */
    public void promptAndImport(String title, FileKind kind, Consumer<String> onImported, Consumer<String> onRefused) {
        filePrompt.apply(title, kind).ifPresent(file -> importFile(kind, file, onImported, onRefused));
    }

    /**
     * Imports a file: copies it to the scene's folder if it is not there.
     *
     * @param onImported  receives the name by which the scene finds the file
     * @param onRefused  receives the reason for a failed import
     */
    public void importFile(FileKind kind, Path file, Consumer<String> onImported, Consumer<String> onRefused) {
        if (editor.document().isUntitled()) {
            onRefused.accept(Messages.tr("Save the scene first: the file is copied to its folder"));
            return;
        }
        Path folder = folder();
        boolean overwrite = file.equals(rejectedFile);
        files.runConcurrently(() -> FileCopy.copyToScene(kind, file, folder, overwrite), outcome -> {
            rejectedFile = outcome instanceof FileCopy.NameConflict ? file : null;
            switch (outcome) {
                case FileCopy.Copied(String name) -> onImported.accept(name);
                case FileCopy.NameConflict(String name) -> onRefused.accept(
                        Messages.tr("The textures folder has another file {0}. Choose the file again to overwrite it", Quote.of(name)));
            }
        }, failure -> onRefused.accept(ErrorMessage.of(failure)));
    }
}
