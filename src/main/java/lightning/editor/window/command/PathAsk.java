package lightning.editor.window.command;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import javafx.stage.DirectoryChooser;
import javafx.stage.FileChooser;
import javafx.stage.Window;
import lightning.base.text.Texts;

/** Asks the artist where a file is or should be; empty where the question was cancelled. */
public interface PathAsk {
    Optional<Path> fileToOpen(String title, String extension);

    /** @param name what the file is called unless the artist says otherwise */
    Optional<Path> fileToSave(String title, String name, String extension);

    Optional<Path> folder(String title);

    /**
     * Asks with the windows of the system.
     *
     * @param from the folder where they open
     */
    static PathAsk inWindows(Window owner, Path from) {
        return new PathAsk() {
            @Override
            public Optional<Path> fileToOpen(String title, String extension) {
                return path(chooser(title, extension, from), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> fileToSave(String title, String name, String extension) {
                FileChooser chooser = chooser(title, extension, from);
                chooser.setInitialFileName(name);
                return path(chooser, c -> c.showSaveDialog(owner));
            }

            @Override
            public Optional<Path> folder(String title) {
                DirectoryChooser chooser = folders(title, from);
                return Optional.ofNullable(FolderGone.without(chooser::setInitialDirectory, () -> chooser.showDialog(owner)))
                        .map(File::toPath);
            }

            private static Optional<Path> path(FileChooser chooser, Function<FileChooser, File> show) {
                return Optional.ofNullable(FolderGone.without(chooser::setInitialDirectory, () -> show.apply(chooser)))
                        .map(File::toPath);
            }
        };
    }

    /** A window that asks for a folder, and opens at one. */
    static DirectoryChooser folders(String title, Path from) {
        var chooser = new DirectoryChooser();
        chooser.setTitle(title);
        chooser.setInitialDirectory(from.toFile());
        return chooser;
    }

    /** A window that asks for a file, and opens at a folder. */
    static FileChooser chooser(String title, String extension, Path from) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(title);
        chooser.setInitialDirectory(from.toFile());
        chooser.getExtensionFilters().addAll(new FileChooser.ExtensionFilter("*." + extension, "*." + extension),
                new FileChooser.ExtensionFilter(Texts.of("All files"), "*"));
        return chooser;
    }
}
