package lightning.editor.window.command;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import javafx.stage.DirectoryChooser;
import javafx.stage.FileChooser;
import javafx.stage.Window;
import lightning.base.text.Messages;

/** Prompts for files and folders; an empty result means that the user canceled. */
public interface PathPrompt {
    Optional<Path> fileToOpen(String title, String extension);

    /** @param name  initial file name */
    Optional<Path> fileToSave(String title, String name, String extension);

    Optional<Path> folder(String title);

    /**
     * Returns a prompt that uses the system's dialogs.
     *
     * @param initialFolder  initial folder of the dialogs
     */
    static PathPrompt ofSystem(Window owner, Path initialFolder) {
        return new PathPrompt() {
            @Override
            public Optional<Path> fileToOpen(String title, String extension) {
                return path(fileChooser(title, extension, initialFolder), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> fileToSave(String title, String name, String extension) {
                FileChooser chooser = fileChooser(title, extension, initialFolder);
                chooser.setInitialFileName(name);
                return path(chooser, c -> c.showSaveDialog(owner));
            }

            @Override
            public Optional<Path> folder(String title) {
                DirectoryChooser chooser = folderChooser(title, initialFolder);
                return Optional.ofNullable(MissingFolderFallback.show(chooser::setInitialDirectory, () -> chooser.showDialog(owner)))
                        .map(File::toPath);
            }

            private static Optional<Path> path(FileChooser chooser, Function<FileChooser, File> show) {
                return Optional.ofNullable(MissingFolderFallback.show(chooser::setInitialDirectory, () -> show.apply(chooser)))
                        .map(File::toPath);
            }
        };
    }

    /** Creates a folder dialog that opens at a folder. */
    static DirectoryChooser folderChooser(String title, Path initialFolder) {
        var chooser = new DirectoryChooser();
        chooser.setTitle(title);
        chooser.setInitialDirectory(initialFolder.toFile());
        return chooser;
    }

    /** Creates a file dialog that opens at a folder. */
    static FileChooser fileChooser(String title, String extension, Path initialFolder) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(title);
        chooser.setInitialDirectory(initialFolder.toFile());
        chooser.getExtensionFilters().addAll(new FileChooser.ExtensionFilter("*." + extension, "*." + extension),
                new FileChooser.ExtensionFilter(Messages.tr("All files"), "*"));
        return chooser;
    }
}
