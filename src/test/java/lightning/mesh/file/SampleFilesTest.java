package lightning.mesh.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.mesh.Mesh;
import lightning.mesh.MeshException;
import lightning.mesh.Part;
import lightning.text.Visible;
import lightning.work.Progress;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Files that other programs wrote, damaged ones among them: each opens, or says why not. Those of Debian's package
 * {@code assimp-testmodels}, or of the folder that {@code -Dlightning.samples=DIR} names; skipped where there are none.
 */
class SampleFilesTest {
    private static final Path FOLDER = Path.of(System.getProperty("lightning.samples", "/usr/share/assimp/models"));

    @TestFactory
    Stream<DynamicTest> everySample_opensOrSaysWhyNot() throws IOException {
        Assumptions.assumeTrue(Files.isDirectory(FOLDER), "no samples in " + FOLDER);
        List<Path> files;
        try (Stream<Path> all = Files.walk(FOLDER)) {
            files = all.filter(Files::isRegularFile).filter(f -> MeshFiles.isNamedSo(f.getFileName().toString())).sorted().toList();
        }
        return files.stream().map(file -> dynamicTest(FOLDER.relativize(file).toString(), () -> opensOrSaysWhyNot(file)));
    }

    private static void opensOrSaysWhyNot(Path file) throws IOException {
        try {
            List<Part> parts = MeshFiles.read(file, Progress.NONE);
            assertThat(parts).isNotEmpty().extracting(Part::mesh).extracting(Mesh::triangleCount).allMatch(count -> count > 0);
        } catch (MeshException e) {
            assertThat(e.getMessage()).matches(Visible::is, "is visible").hasSizeLessThan(2000);
        }
    }
}
