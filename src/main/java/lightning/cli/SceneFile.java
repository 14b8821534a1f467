package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import lightning.base.file.ShippedFile;
import lightning.cli.output.Console;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import picocli.CommandLine.Parameters;

/** Argument {@code scene.jen}. */
final class SceneFile {
    @Parameters(index = "0", paramLabel = "scene.jen", description = "Scene file.")
    private Path path;

    Path path() {
        return ShippedFile.resolve(path);
    }

    /** Returns the scene file and the files that a scene of it references. */
    InputFiles inputs(Scene... scenes) {
        return InputFiles.of(path(), List.of(scenes));
    }

    /** Reads the scene; prints a line for each file that it lacks. */
    JenDocument read(Console console) throws IOException, JenException {
        return read(path(), console);
    }

    /** Reads a scene file; prints a line for each file that it lacks. */
    static JenDocument read(Path file, Console console) throws IOException, JenException {
        JenDocument document = JenReader.read(file);
        document.notes().forEach(note -> console.warn("%s", note));
        return document;
    }
}
