package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What the assembled program ships. */
class ProgramFolderIT {
    private static final Path PROGRAM = Path.of("target/lightning");
    /** {@code javafx-base-26.0.2-linux.jar}: name, version, and for some the platform. */
    private static final Pattern LIBRARY = Pattern.compile("(.+?)-(\\d.*?)(?:-(?:linux|mac|win)(?:-aarch64)?)?\\.jar");

    @Test
    void everyLibrary_isListedWithItsLicence() throws IOException {
        List<String> lines = Files.readAllLines(PROGRAM.resolve("licences.txt"));
        assertThat(libraries()).isNotEmpty().allSatisfy(library -> assertThat(lines)
                .filteredOn(line -> line.contains(":" + library + " ")).singleElement().asString().matches("\\s*\\(\\w[^)].*\\) .+"));
        assertThat(lines.toString()).doesNotContainIgnoringCase("unknown license");
    }

    @Test
    void commonsLang_isNewerThanTheOneThatRecursedWithoutEnd() throws IOException {
        // CVE-2025-48924: all before 3.18.0.
        assertThat(libraries()).filteredOn(library -> library.startsWith("commons-lang3:")).singleElement().asString()
                .matches("commons-lang3:3\\.(1[89]|[2-9]\\d).*");
    }

    /** Name and version, as in {@code picocli:4.7.7}, but the program's own. */
    private static List<String> libraries() throws IOException {
        try (Stream<Path> jars = Files.list(PROGRAM.resolve("lib"))) {
            return jars.map(jar -> jar.getFileName().toString()).filter(jar -> !jar.equals("lightning.jar")).map(jar -> {
                Matcher library = LIBRARY.matcher(jar);
                assertThat(library.matches()).as(jar).isTrue();
                return library.group(1) + ":" + library.group(2);
            }).distinct().toList();
        }
    }
}
