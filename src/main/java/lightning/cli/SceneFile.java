package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.jen.JenDocument;
import lightning.jen.JenException;
import lightning.jen.JenReader;
import lightning.text.Quote;
import picocli.CommandLine.Parameters;

/** The argument {@code scene.jen}. */
final class SceneFile {
    @Parameters(index = "0", paramLabel = "scene.jen", description = "The scene.")
    private Path path;

    Path path() {
        return path;
    }

    JenDocument read() throws IOException, JenException, BadInput {
        return read(path);
    }

    /** Reads a scene, with the file's name in every complaint. */
    static JenDocument read(Path path) throws IOException, JenException, BadInput {
        if (Files.isDirectory(path)) {
            throw new BadInput(Quote.path(path) + ": is a folder, expected a .jen file");
        }
        if (Files.exists(path) && !Files.isRegularFile(path)) {
            throw new BadInput(path + ": is no file but a pipe or a device, expected a .jen file");
        }
        return JenReader.read(path);
    }
}
