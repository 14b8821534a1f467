package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Control characters in file names and quoted input never reach the terminal. */
class HostileInputTest {
    private static final String HOSTILE = "\u001B[31mred\u202E\r\u0007\u009B2J";

    @TempDir
    Path folder;

    private static void assertNoControlCharacters(CliResult cli) {
        assertThat((cli.out() + cli.err()).lines()).allMatch(PrintableText::isPrintable);
    }

    static Stream<List<String>> wrongWords() {
        return Stream.of(List.of(HOSTILE), List.of(HOSTILE + ".jen"), List.of("render", HOSTILE + ".jen", "-o", "a.png"),
                List.of("render", "scenes/bird.jen", "-o", HOSTILE), List.of("render", "scenes/bird.jen", "-o", HOSTILE + "/a.png"),
                List.of("render", "scenes/bird.jen", "-o", "a.png", "--size", HOSTILE),
                List.of("render", "scenes/bird.jen", "-o", "a.png", "--depth", HOSTILE),
                List.of("render", "scenes/bird.jen", "-o", "a.png", "--antialias", HOSTILE),
                List.of("render", "scenes/bird.jen", "--" + HOSTILE), List.of("check", "scenes/bird.jen", HOSTILE),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--set", HOSTILE + ".x=1"),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--set", "lamp." + HOSTILE + "=1"),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--set", "lamp.name=" + HOSTILE),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--add", HOSTILE),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--delete", HOSTILE),
                List.of("relight", "scenes/bird.jen", "-o", "a.png", "--case", HOSTILE),
                List.of("explain", "scenes/bird.jen", HOSTILE), List.of("compare", HOSTILE + ".png", "b.png"),
                List.of("export", "scenes/bird.jen", "-o", HOSTILE), List.of("tour", HOSTILE + ".jen"),
                List.of("bench", HOSTILE + ".jen", "--baseline", HOSTILE));
    }

    @ParameterizedTest
    @MethodSource("wrongWords")
    void error_isPrintable(List<String> words) {
        CliResult refused = CliResult.run(words.toArray());
        assertThat(refused.exit()).as(refused.err()).isEqualTo(2);
        assertNoControlCharacters(refused);
    }

    @Test
    void sceneName_isQuoted() throws IOException {
        Path scene = Files.writeString(folder.resolve("a\n" + HOSTILE + ".jen"), CliResult.SCENE);
        CliResult checked = CliResult.run("check", scene).assertSuccess();
        assertNoControlCharacters(checked);
        assertThat(checked.out()).startsWith(Quote.path(scene) + ": no problems").hasLineCount(1);
        Path wrong = Files.writeString(folder.resolve("b\n" + HOSTILE + ".jen"), "jen 1\n\u001B[2J light \"" + HOSTILE + "\" point {}");
        CliResult refused = CliResult.run("check", wrong);
        refused.assertRejected(Quote.path(wrong) + ":2:");
        assertNoControlCharacters(refused);
        assertThat(refused.err().lines()).allMatch(line -> line.startsWith(Quote.path(wrong) + ":2:"));
    }
}
