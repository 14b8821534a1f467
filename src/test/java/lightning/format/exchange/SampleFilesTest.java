package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.Visible;
import lightning.base.work.Progress;
import lightning.base.work.Wait;
import lightning.format.MeshFormat;
import lightning.format.mesh.MeshException;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Files that other programs wrote, damaged ones among them: each opens, or says why not. Those of Debian's package
 * {@code assimp-testmodels}, or of the folder that {@code -Dlightning.samples=DIR} names; skipped where there are none, unless the
 * environment has {@code LIGHTNING_NEEDS_SAMPLES}.
 */
class SampleFilesTest {
    private static final Path FOLDER = Path.of(System.getProperty("lightning.samples", "/usr/share/assimp/models"));
    /** The largest has 2 MB: a reader that takes longer hangs. */
    private static final Duration LONGEST = Duration.ofSeconds(Wait.MOST_SECONDS);

    @TempDir
    private Path folder;

    @TestFactory
    Stream<DynamicTest> everySample_opensOrSaysWhyNot() throws IOException {
        Assumptions.assumeTrue(Files.isDirectory(FOLDER) || System.getenv("LIGHTNING_NEEDS_SAMPLES") != null, "no samples in " + FOLDER);
        List<Path> files;
        try (Stream<Path> all = Files.walk(FOLDER)) {
            files = all.filter(Files::isRegularFile).filter(f -> MeshFormat.isNamedSo(f.getFileName().toString())).sorted().toList();
        }
        assertThat(files).isNotEmpty();
        return files.stream().map(file -> dynamicTest(FOLDER.relativize(file).toString(), () -> opensOrSaysWhyNot(file)));
    }

    private void opensOrSaysWhyNot(Path file) {
        assertTimeoutPreemptively(LONGEST, () -> {
            try {
                Import read = Importer.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
                assertThat(read.scene().placedShapes()).isNotEmpty();
                assertThat(read.notes().keySet()).allMatch(Visible::is);
            } catch (MeshException e) {
                assertThat(e.getMessage()).matches(Visible::is, "is visible").hasSizeLessThan(2000);
            }
        });
    }
}
