package lightning.app;

import java.nio.file.Path;
import java.util.Optional;
import javafx.stage.DirectoryChooser;
import javafx.stage.FileChooser;
import javafx.stage.Window;

/** Asks the artist where a file is or should be; empty where the question was cancelled. */
interface PathAsk {
    Optional<Path> fileToOpen(String title, String extension);

    /** @param name what the file is called unless the artist says otherwise */
    Optional<Path> fileToSave(String title, String name, String extension);

    Optional<Path> folder(String title);

    /** Asks with the windows of the system. */
    static PathAsk inWindows(Window owner) {
        return new PathAsk() {
            @Override
            public Optional<Path> fileToOpen(String title, String extension) {
                return Optional.ofNullable(chooser(title, extension).showOpenDialog(owner)).map(f -> f.toPath());
            }

            @Override
            public Optional<Path> fileToSave(String title, String name, String extension) {
                FileChooser chooser = chooser(title, extension);
                chooser.setInitialFileName(name);
                return Optional.ofNullable(chooser.showSaveDialog(owner)).map(f -> f.toPath());
            }

            @Override
            public Optional<Path> folder(String title) {
                DirectoryChooser chooser = new DirectoryChooser();
                chooser.setTitle(title);
                return Optional.ofNullable(chooser.showDialog(owner)).map(f -> f.toPath());
            }
        };
    }

    private static FileChooser chooser(String title, String extension) {
        FileChooser chooser = new FileChooser();
        chooser.setTitle(title);
        chooser.getExtensionFilters().addAll(new FileChooser.ExtensionFilter("*." + extension, "*." + extension),
                new FileChooser.ExtensionFilter("All files", "*"));
        return chooser;
    }
}
