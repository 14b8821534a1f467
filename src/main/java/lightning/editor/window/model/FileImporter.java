package lightning.editor.window.model;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.editor.document.FileThread;
import lightning.format.jen.FileCopy;
import lightning.format.jen.FileKind;

/** Brings files from elsewhere to where the open scene finds them; over another of that name only if one is chosen twice. */
public final class FileImporter {
    private final SceneEditor editor;
    private final FileThread files;
    private BiFunction<String, FileKind, Optional<Path>> filePrompt = (_, _) -> Optional.empty();
    /** A file that was chosen, whose name another has; null where there is none. */
    private Path rejectedFile;

    FileImporter(SceneEditor editor, FileThread files) {
        this.editor = editor;
        this.files = files;
    }

    /** The folder that the open scene lies in. */
    public Path folder() {
        return editor.document().file().toAbsolutePath().getParent();
    }

    /** Reads the files that the scene finds there. */
    public FileThread files() {
        return files;
    }

    /** Says who asks for a file; it gets the title of the question. */
    public void setFilePrompt(BiFunction<String, FileKind, Optional<Path>> prompt) {
        filePrompt = prompt;
    }

    /**
     * Asks for a file from anywhere and brings it, unless the artist thinks better of it.
     *
     * @param title   of the question
     * @param onImported hears the name by which the scene finds it
     * @param onRefused hears why it was not brought
     */
    public void promptAndImport(String title, FileKind kind, Consumer<String> onImported, Consumer<String> onRefused) {
        filePrompt.apply(title, kind).ifPresent(file -> importFile(kind, file, onImported, onRefused));
    }

    private void importFile(FileKind kind, Path file, Consumer<String> onImported, Consumer<String> onRefused) {
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
