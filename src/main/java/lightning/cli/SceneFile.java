package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import lightning.base.file.ShippedFile;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import picocli.CommandLine.Parameters;

/** Argument {@code scene.jen}. */
final class SceneFile {
    @Parameters(index = "0", paramLabel = "scene.jen", description = "Scene file.")
    private Path path;

    Path path() {
        return ShippedFile.resolve(path);
    }

    JenDocument read() throws IOException, JenException {
        return JenReader.read(path());
    }
}
