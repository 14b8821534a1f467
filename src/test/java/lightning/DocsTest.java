package lightning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import lightning.DocCommands.Command;
import lightning.cli.Lightning;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * What README.md and the pages in docs show is true: each {@code lightning …} line is run as it
 * stands, and each {@code mvn …} line is one of the commands that the project promises.
 */
class DocsTest {
    private static final Path README = Path.of("README.md");
    private static final String ARGUMENTS = "-Dlightning.args=";
    private static final Set<List<String>> PROMISED = Set.of(
            List.of("mvn", "-q", "compile", "exec:exec"),
            List.of("mvn", "verify"),
            List.of("mvn", "-q", "package", "-DskipTests"),
            List.of("mvn", "-q", "-Prelease", "-DskipTests", "package"));

    @TempDir
    private Path folder;

    @Test
    void words_keepQuotedSpacesAndDropComments() {
        assertThat(DocCommands.words("lightning  render 'a b.jen' --set=\"c d\" # why"))
                .containsExactly("lightning", "render", "a b.jen", "--set=c d");
    }

    @Test
    void commands_areThoseOfShellBlocksOnly() {
        String page = """
                lightning no
                ```java
                lightning no
                ```
                ```sh
                # first
                lightning check \\
                    a.jen   # exit 2

                mvn verify
                ```
                """;
        assertThat(DocCommands.of(page)).containsExactly(
                new Command(List.of("lightning", "check", "a.jen"), 2),
                new Command(List.of("mvn", "verify"), 0));
    }

    @Test
    void outputs_goToAFolderOfTheirOwn() {
        Set<String> outputs = new HashSet<>();
        assertThat(inFolder(outputs, "render", "a.jen", "-o", "out.png"))
                .containsExactly("render", "a.jen", "-o", folder.resolve("out.png").toString());
        assertThat(inFolder(outputs, "compare", "out.png", "b.png"))
                .containsExactly("compare", folder.resolve("out.png").toString(), "b.png");
    }

    @Test
    void readme_namesEveryPromisedCommand() throws IOException {
        assertThat(DocCommands.of(Files.readString(README))).extracting(Command::words).containsAll(PROMISED);
    }

    @Test
    void ci_callsTheTestCommandOfTheReadme() throws IOException {
        assertThat(Files.readAllLines(Path.of(".ci/run"))).contains("exec mvn verify </dev/null");
    }

    @TestFactory
    Stream<DynamicTest> everyShownCommand_doesWhatItSays() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path page : pages()) {
            Set<String> outputs = new HashSet<>();
            for (Command command : DocCommands.of(Files.readString(page))) {
                tests.add(dynamicTest(page + ": " + String.join(" ", command.words()),
                        () -> check(command, outputs)));
            }
        }
        return tests.stream();
    }

    private void check(Command command, Set<String> outputs) {
        switch (command.name()) {
            case "lightning" -> run(outputs, command.exit(), command.arguments());
            case "mvn" -> checkMaven(command, outputs);
            default -> {}
        }
    }

    /** Checks a Maven line, and runs the arguments that it hands to the program. */
    private void checkMaven(Command command, Set<String> outputs) {
        List<String> plain = command.words().stream().filter(word -> !word.startsWith("-Dlightning.")
                && !word.startsWith("-Djqwik.")).toList();
        assertThat(PROMISED).contains(plain);
        command.words().stream().filter(word -> word.startsWith(ARGUMENTS))
                .map(word -> DocCommands.words(word.substring(ARGUMENTS.length())))
                .forEach(words -> run(outputs, command.exit(), words.toArray(String[]::new)));
    }

    private void run(Set<String> outputs, int exit, String... arguments) {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int code = program(new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8), inFolder(outputs, arguments));
        assertThat(code).as("%s%s", out, err).isEqualTo(exit);
    }

    /** Runs the program in this JVM and returns its exit code. */
    private static int program(PrintStream out, PrintStream err, String... arguments) {
        return Lightning.run(out, err, arguments);
    }

    /** Sends the files that a page's commands write (-o, --save), and read again later, to the test's folder. */
    private String[] inFolder(Set<String> outputs, String... arguments) {
        String[] moved = arguments.clone();
        for (int i = 0; i < moved.length; i++) {
            if (i > 0 && (moved[i - 1].equals("-o") || moved[i - 1].equals("--save"))) {
                outputs.add(moved[i]);
            }
            if (outputs.contains(moved[i])) {
                moved[i] = folder.resolve(moved[i]).toString();
            }
        }
        return moved;
    }

    private static List<Path> pages() {
        List<Path> pages = new ArrayList<>(List.of(README));
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            docs.filter(page -> page.toString().endsWith(".md")).sorted().forEach(pages::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return pages;
    }
}
