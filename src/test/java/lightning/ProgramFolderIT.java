package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** What the assembled program ships. */
class ProgramFolderIT {
    private static final Path PROGRAM = Path.of("target/lightning");
    /** {@code javafx-base-26.0.2-linux.jar}: name, version, and for some the platform. */
    private static final Pattern LIBRARY = Pattern.compile("(.+?)-(\\d.*?)(?:-(?:linux|mac|win)(?:-aarch64)?)?\\.jar");

    @TempDir
    private Path folder;

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

    @Test
    @EnabledOnOs(OS.LINUX)
    void resultsIntoAFullDevice_areAComplaintWithExitCode2() throws Exception {
        Path err = folder.resolve("err");
        Process check = launcher(folder, "check", Path.of("scenes/bird.jen").toAbsolutePath().toString())
                .redirectOutput(new File("/dev/full")).redirectError(err.toFile()).start();
        assertThat(check.waitFor()).isEqualTo(2);
        assertThat(Files.readString(err)).contains("lightning: the results could not be written to the standard output")
                .doesNotContain("Exception");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void sceneWithLettersBeyondAscii_isReadInTheLocaleC() throws Exception {
        String name = "Käfer-光.jen";
        // Java of a test may be in the locale C itself, and could not name the file; a shell can.
        Path script = Files.writeString(folder.resolve("copy.sh"), "cp \"$1\" '" + name + "' && exec \"$2\" check '" + name + "'\n");
        Path scene = Files.writeString(folder.resolve("plain.jen"), "jen 1\nsphere ball { }\nlight lamp point { at 0 3 3 }\n");
        Path out = folder.resolve("out");
        Path err = folder.resolve("err");
        var builder = new ProcessBuilder("bash", script.toString(), scene.toString(),
                PROGRAM.resolve("bin/lightning").toAbsolutePath().toString())
                .directory(folder.toFile()).redirectOutput(out.toFile()).redirectError(err.toFile());
        builder.environment().keySet().removeIf(variable -> variable.startsWith("LC_") || variable.equals("LANG"));
        builder.environment().put("LC_ALL", "C");
        assertThat(builder.start().waitFor()).as(Files.readString(err)).isZero();
        assertThat(Files.readString(out)).startsWith(name + ": no problems; 1 shape (1 sphere)");
    }

    private static ProcessBuilder launcher(Path in, String... arguments) {
        List<String> line = new ArrayList<>(List.of(PROGRAM.resolve("bin/lightning").toAbsolutePath().toString()));
        line.addAll(List.of(arguments));
        return new ProcessBuilder(line).directory(in.toFile());
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
