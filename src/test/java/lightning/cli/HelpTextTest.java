package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Wording of help and results. */
class HelpTextTest {
    /** Number before a plural; excludes parts and sizes, as in "1 of 2 pixels", where any number is correct. */
    private static final Pattern UNCOUNTED = Pattern.compile("(?<!of |x |to )%d (?!is\\b)(?:shadow |eye )?[a-z]+s\\b");

    @ParameterizedTest
    @ValueSource(strings = {"render", "relight"})
    void shotOutput_isDescribedAsFolder(String command) {
        String help = CliResult.run("shot", command, "--help").assertSuccess().out();
        assertThat(help).contains("--output=FOLDER", "Output folder").doesNotContain("Output image:");
        assertThat(CliResult.run(command, "--help").assertSuccess().out()).contains("--output=FILE", "Output image:");
    }

    @Test
    void everyCount_usesConsoleCount() throws IOException {
        try (Stream<Path> sources = Files.list(Path.of("src/main/java/lightning/cli"))) {
            for (Path source : sources.filter(Files::isRegularFile).toList()) {
                List<String> found = UNCOUNTED.matcher(Files.readString(source)).results().map(MatchResult::group).toList();
                assertThat(found).as(source.toString()).isEmpty();
            }
        }
    }
}
