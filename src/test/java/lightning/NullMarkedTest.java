package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.base.Initializer;
import org.junit.jupiter.api.Test;

/** Tests that the check of null values, {@code mvn compile -Pnullness}, covers all of the program. */
class NullMarkedTest {
    private static final Path PROGRAM = Path.of("src/main/java/lightning");

    private static List<Path> files(Predicate<Path> selected) throws IOException {
        try (Stream<Path> files = Files.walk(PROGRAM)) {
            return files.filter(file -> file.toString().endsWith(".java")).filter(selected).toList();
        }
    }

    private static boolean contains(Path file, String text) {
        try {
            return Files.exists(file) && Files.readString(file).contains(text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void everyPackage_isNullMarked() throws IOException {
        List<Path> folders = files(_ -> true).stream().map(Path::getParent).distinct().toList();
        assertThat(folders).contains(PROGRAM, PROGRAM.resolve("render/gather"));
        assertThat(folders.stream().filter(folder -> !contains(folder.resolve("package-info.java"), "\n@NullMarked\npackage "))).isEmpty();
    }

    @Test
    void noClass_isExempt() throws IOException {
        assertThat(files(file -> contains(file, "@NullUnmarked") || contains(file, "\"NullAway"))).isEmpty();
    }

    @Test
    void check_knowsTheAnnotationOfInitializers() throws IOException {
        assertThat(Files.readString(Path.of("pom.xml"))).contains("CustomInitializerAnnotations=" + Initializer.class.getName() + " ");
    }

    @Test
    void continuousCheck_includesIt() throws IOException {
        assertThat(Files.readString(Path.of("pom.xml"))).contains("<name>env.LIGHTNING_CHECKS_NULLNESS</name>");
        assertThat(Files.readString(Path.of(".ci/run"))).contains("export LIGHTNING_CHECKS_NULLNESS=1\n");
    }
}
