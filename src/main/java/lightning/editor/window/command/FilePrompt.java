package lightning.editor.window.command;

import java.io.File;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import javafx.stage.FileChooser;
import javafx.stage.Window;
import lightning.base.file.ParentFolder;
import lightning.base.text.Messages;
import lightning.format.exchange.SceneImporter;
import lightning.format.image.CubeLutReader;
import lightning.format.image.ImageFormat;
import lightning.format.jen.JenFile;
import lightning.format.jen.asset.FileKind;
import org.jspecify.annotations.Nullable;

/** Prompts for files; an empty result means that the user canceled. */
public interface FilePrompt {
    /** Prompts for a scene to open, or a file to import. */
    Optional<Path> sceneToOpen(Path folder);

    /** Prompts for a file to write a scene to. */
    Optional<Path> sceneToWrite(Path proposal);

    /** Prompts for a file to write a picture to. */
    Optional<Path> pictureToWrite(Path proposal);

    /** Prompts for a review page to write. */
    default Optional<Path> pageToWrite(Path proposal) {
        return pictureToWrite(proposal);
    }

    /** Prompts for a review to read. */
    default Optional<Path> reviewToOpen(Path folder) {
        return sceneToOpen(folder);
    }

    /** Prompts for a light rig to read. */
    default Optional<Path> rigToOpen(Path folder) {
        return sceneToOpen(folder);
    }

    /** Prompts for a file to write a light rig to. */
    default Optional<Path> rigToWrite(Path proposal) {
        return sceneToWrite(proposal);
    }

    /** Prompts for a color lookup table to read. */
    default Optional<Path> tableToOpen(Path folder) {
        return sceneToOpen(folder);
    }

    /** Prompts for a configuration of OpenColorIO to read. */
    default Optional<Path> configToOpen(Path folder) {
        return sceneToOpen(folder);
    }

    /** Prompts for an asset to copy next to the scene. */
    default Optional<Path> assetToOpen(String title, FileKind kind, Path folder) {
        return sceneToOpen(folder);
    }

    /** Prompts for a file that a scene names and its folders lack. */
    default Optional<Path> missingFileToOpen(String name, Path folder) {
        return sceneToOpen(folder);
    }

    /** Returns a prompt that uses the system's file dialogs. */
    static FilePrompt ofSystem(Window owner) {
        var scenes = filter("Scenes", JenFile.EXTENSION);
        var files = new FileChooser.ExtensionFilter(Messages.tr("Scenes and files of other programs"),
                Stream.concat(Stream.of(JenFile.EXTENSION), SceneImporter.extensions().stream()).map(ending -> "*" + ending).toList());
        var configs = new FileChooser.ExtensionFilter(Messages.tr("OpenColorIO configurations"), "*.ocio", "*.ocioz");
        var tables = filter("LUTs", CubeLutReader.EXTENSION);
        return new FilePrompt() {
            @Override
            public Optional<Path> sceneToOpen(Path folder) {
                return path(chooser(Messages.tr("Open"), folder, files), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> sceneToWrite(Path proposal) {
                var chooser = chooser(Messages.tr("Save Scene As"), ParentFolder.of(proposal), scenes);
                chooser.setInitialFileName(proposal.getFileName().toString());
                return path(chooser, c -> c.showSaveDialog(owner));
            }

            @Override
            public Optional<Path> pageToWrite(Path proposal) {
                var chooser = chooser(Messages.tr("Export Review Page"), ParentFolder.of(proposal), filter("HTML", ".html"));
                chooser.setInitialFileName(proposal.getFileName().toString());
                return path(chooser, c -> c.showSaveDialog(owner));
            }

            @Override
            public Optional<Path> reviewToOpen(Path folder) {
                return path(chooser(Messages.tr("Open Review"), folder, filter("JSON", ".json")), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> rigToOpen(Path folder) {
                return path(chooser(Messages.tr("Import Light Rig"), folder, scenes), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> tableToOpen(Path folder) {
                return path(chooser(Messages.tr("Load LUT"), folder, tables), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> configToOpen(Path folder) {
                return path(chooser(Messages.tr("Open"), folder, configs), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> assetToOpen(String title, FileKind kind, Path folder) {
                var files = new FileChooser.ExtensionFilter(kind.title(), kind.endings().stream().map(ending -> "*." + ending).toList());
                return path(chooser(title, folder, files), c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> missingFileToOpen(String name, Path folder) {
                return path(
                        chooser(Messages.tr("Locate {0}", name), folder, filter(name, name.substring(Math.max(0, name.lastIndexOf('.'))))),
                        c -> c.showOpenDialog(owner));
            }

            @Override
            public Optional<Path> rigToWrite(Path proposal) {
                var chooser = chooser(Messages.tr("Export Light Rig"), ParentFolder.of(proposal), scenes);
                chooser.setInitialFileName(proposal.getFileName().toString());
                return path(chooser, c -> c.showSaveDialog(owner));
            }

            @Override
            public Optional<Path> pictureToWrite(Path proposal) {
                String name = proposal.getFileName().toString();
                var chooser = chooser(Messages.tr("Save Image"), ParentFolder.of(proposal),
                        ImageFormat.written().stream().sorted(Comparator.comparing(format -> !name.endsWith(format.extension())))
                                .map(format -> filter(format.title(), format.extension())).toArray(FileChooser.ExtensionFilter[]::new));
                chooser.setInitialFileName(proposal.getFileName().toString());
                return path(chooser, c -> c.showSaveDialog(owner));
            }
        };
    }

    private static FileChooser.ExtensionFilter filter(String title, String ending) {
        return new FileChooser.ExtensionFilter(title + " (*" + ending + ")", "*" + ending);
    }

    private static FileChooser chooser(String title, @Nullable Path folder, FileChooser.ExtensionFilter... filters) {
        var chooser = new FileChooser();
        chooser.setTitle(title);
        chooser.getExtensionFilters().setAll(filters);
        if (folder != null) {
            chooser.setInitialDirectory(folder.toAbsolutePath().toFile());
        }
        return chooser;
    }

    private static Optional<Path> path(FileChooser chooser, Function<FileChooser, File> show) {
        return Optional.ofNullable(MissingFolderFallback.show(chooser::setInitialDirectory, () -> show.apply(chooser))).map(File::toPath);
    }
}
