package lightning.format.exchange;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.MeshFormat;
import lightning.format.assimp.AssimpFormat;
import lightning.format.exchange.assembly.ImportedScene;
import lightning.format.exchange.assembly.LightUnits;
import lightning.format.mesh.MeshException;
import lightning.sample.Nightly;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Sample files of other programs, including damaged ones: each opens or gives an error message. Uses Debian's package {@code
 * assimp-testmodels} or the folder of {@code -Dlightning.samples=DIR}; skipped if there are none, unless the environment
 * contains {@code LIGHTNING_NEEDS_SAMPLES}.
 */
class SampleFilesTest {
    private static final Path FOLDER = Path.of(System.getProperty("lightning.samples", "/usr/share/assimp/models"));
    /** Time limit: the largest file has 2 MB, so a slower reader hangs. */
    private static final Duration MAX_DURATION = Duration.ofSeconds(Await.TIMEOUT_SECONDS);

    @TempDir
    private Path folder;

    @TestFactory
    Stream<DynamicTest> everySampleFile_opensOrReportsWhy() throws IOException {
        return tests(MeshFormat::isMeshFileName);
    }

    /** Each starts a process. */
    @Nightly
    @TestFactory
    Stream<DynamicTest> everySampleFileForAssimp_opensOrReportsWhy() throws IOException {
        return tests(AssimpFormat::isModelName);
    }

    private Stream<DynamicTest> tests(Predicate<String> isTried) throws IOException {
        Assumptions.assumeTrue(Files.isDirectory(FOLDER) || System.getenv("LIGHTNING_NEEDS_SAMPLES") != null, "no samples in " + FOLDER);
        List<Path> files;
        try (Stream<Path> paths = Files.walk(FOLDER)) {
            files = paths.filter(Files::isRegularFile).filter(f -> isTried.test(f.getFileName().toString())).sorted().toList();
        }
        assertThat(files).isNotEmpty();
        return files.stream().map(file -> dynamicTest(FOLDER.relativize(file).toString(), () -> opensOrReports(file)));
    }

    private void opensOrReports(Path file) {
        assertTimeoutPreemptively(MAX_DURATION, () -> {
            try {
                ImportedScene imported = SceneImporter.read(file, folder.resolve("a.jen"), LightUnits.CANDELA, Progress.NONE);
                assertThat(!imported.scene().placedShapes().isEmpty()
                        || !imported.scene().lights().isEmpty()).isTrue();
                assertThat(imported.notes().keySet()).allMatch(PrintableText::isPrintable);
            } catch (MeshException e) {
                assertThat(e.getMessage()).matches(PrintableText::isPrintable, "is visible").hasSizeLessThan(2000);
            }
        });
    }
}
