package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.DocCommands.Command;
import org.junit.jupiter.api.Test;

/** Tests that the commands of README.md and docs are parsed as intended, and that the {@code mvn …} lines are the expected ones. */
class DocsTest {
    private static final Path README = Path.of("README.md");
    private static final Path DECISIONS = Path.of("docs", "decisions");
    /** A link in Markdown; the group is its target without the heading. */
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#\\s]+)(?:#[^)\\s]*)?\\)");
    /** Without {@code -q}, which only hides Maven's own output. */
    private static final Set<List<String>> REQUIRED_COMMANDS = Set.of(
            List.of("mvn", "compile", "exec:exec"),
            List.of("mvn", "test"),
            List.of("mvn", "verify"),
            List.of("mvn", "package", "-DskipTests"),
            List.of("mvn", "-Prelease", "-DskipTests", "package"));

    @Test
    void words_quotedAndCommented_areSplitLikeShell() {
        assertThat(DocCommands.words("lightning  render 'a b.jen' --set=\"c d\" # why"))
                .containsExactly("lightning", "render", "a b.jen", "--set=c d");
    }

    @Test
    void commands_comeFromShellBlocksOnly() {
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
    void readme_listsEveryRequiredCommand() throws IOException {
        assertThat(DocCommands.of(Files.readString(README))).extracting(DocsTest::withoutOptions).containsAll(REQUIRED_COMMANDS);
    }

    /** The first run downloads the libraries and must show this. */
    @Test
    void firstCommandOfTheReadme_isNotSilent() throws IOException {
        assertThat(DocCommands.of(Files.readString(README)).getFirst().words()).containsExactly("mvn", "compile", "exec:exec");
    }

    @Test
    void ci_runsTheTestCommandOfTheReadme() throws IOException {
        assertThat(Files.readAllLines(Path.of(".ci/run"))).contains("[[ ${1:--} != -* ]] || set -- verify \"$@\"",
                ".ci/quiet mvn \"$@\" </dev/null || status=$?");
    }

    @Test
    void everyMavenCommand_isRequired() throws IOException {
        for (Path page : pages()) {
            assertThat(DocCommands.of(Files.readString(page))).filteredOn(command -> command.name().equals("mvn"))
                    .allSatisfy(command -> assertThat(REQUIRED_COMMANDS).as(page.toString()).contains(withoutOptions(command)));
        }
    }

    private static List<String> withoutOptions(Command command) {
        return command.words().stream()
                .filter(word -> !word.equals("-q") && !word.startsWith("-Dlightning.") && !word.startsWith("-Djqwik.")).toList();
    }

    @Test
    void everyRelativeLink_leadsToAFile() throws IOException {
        for (Path page : pages()) {
            assertThat(LINK.matcher(Files.readString(page)).results().map(link -> link.group(1)).filter(target -> !target.contains(":")))
                    .as(page.toString()).allSatisfy(target -> assertThat(page.resolveSibling(target)).exists());
        }
    }

    @Test
    void everyDecision_isListed() throws IOException {
        Path index = DECISIONS.resolve("README.md");
        try (Stream<Path> decisions = Files.list(DECISIONS)) {
            String links = Files.readString(index);
            assertThat(decisions.filter(page -> page.toString().endsWith(".md") && !page.equals(index))).isNotEmpty()
                    .allSatisfy(page -> assertThat(links).contains("](" + page.getFileName() + ")"));
        }
    }

    @Test
    void unusedNumbers_areThoseWithoutAPage() throws IOException {
        try (Stream<Path> decisions = Files.list(DECISIONS)) {
            Set<Integer> used = decisions.map(page -> page.getFileName().toString()).filter(name -> name.matches("\\d{4}-.*"))
                    .map(name -> Integer.parseInt(name.substring(0, 4))).collect(Collectors.toSet());
            List<Integer> missing = IntStream.range(1, Collections.max(used)).boxed().filter(n -> !used.contains(n)).toList();
            String text = Files.readString(DECISIONS.resolve("README.md")).replaceFirst("(?s).*Unused numbers:([\\d,\\s]+)\\..*", "$1");
            assertThat(Arrays.stream(text.strip().split(",\\s*")).map(Integer::parseInt)).isEqualTo(missing);
        }
    }

    static List<Path> pages() {
        List<Path> pages = new ArrayList<>(List.of(README));
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            docs.filter(page -> page.toString().endsWith(".md")).sorted().forEach(pages::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return pages;
    }
}
