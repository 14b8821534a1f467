package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Help by a command, manual pages, completion, and suggestions for misspelled words. */
class HelpCommandTest {
    @TempDir
    Path folder;

    @Test
    void help_equalsTheOption() {
        for (HelpPages.Page page : HelpPages.all()) {
            List<String> words = List.of(page.name().split(" "));
            List<String> help = new ArrayList<>(List.of("help"));
            help.addAll(words.subList(1, words.size()));
            assertThat(CliResult.run(help.toArray()).assertSuccess().out()).isEqualTo(page.text());
        }
    }

    @Test
    void misspelledWords_haveSuggestions() {
        CliResult.run("help", "shot", "rendr").assertRejected("did you mean 'render'?");
        CliResult.run("rendr", "a.jen").assertRejected("did you mean 'render'?");
        CliResult.run("shot", "relihgt", "a.jen").assertRejected("did you mean 'relight'?");
        CliResult.run("render", "a.jen", "--siez", "2x2").assertRejected("did you mean '--size'?");
        CliResult.run("render", "--siez=2x2").assertRejected("did you mean '--size'?");
        CliResult.run("relight", "a.jen", "--sett", "x").assertRejected("'--output=FILE'; unknown option '--sett'; did you mean '--set'?");
    }

    @Test
    void everyCommand_hasAManualPage_withAllOptionsAndExamples() throws IOException {
        CliResult.run("help", "--man", folder).assertSuccess();
        for (HelpPages.Page page : HelpPages.all()) {
            String text = Files.readString(folder.resolve(page.name().replace(' ', '-') + ".1"));
            assertThat(text).contains(".SH NAME", ".SH SYNOPSIS", ".SH OPTIONS", ".SH EXAMPLES", "\\fB\\-\\-json\\fR");
            page.text().lines().filter(line -> line.startsWith("  lightning ")).forEach(
                    line -> assertThat(text).contains(line.strip().replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")));
        }
    }

    @Test
    void manualPages_areReadableByMan() throws IOException, InterruptedException {
        CliResult.run("help", "--man", folder).assertSuccess();
        try (Stream<Path> pages = Files.list(folder)) {
            for (Path page : pages.toList()) {
                assertThat(runIfInstalled("groff", "-man", "-ww", "-z", page.toString())).isEmpty();
            }
        }
    }

    @Test
    void completion_completesCommandsAndOptions() throws IOException, InterruptedException {
        Path script = Files.writeString(folder.resolve("script"), CliResult.run("completion", "bash").assertSuccess().out());
        assertThat(complete(script, "lightning", "rend")).isEqualTo("render");
        assertThat(complete(script, "lightning", "shot", "rel")).isEqualTo("relight");
        assertThat(complete(script, "lightning", "render", "--trad")).isEqualTo("--traditional");
        assertThat(complete(script, "lightning", "render", "a.jen", "--antialias", "ev")).isEqualTo("every");
        assertThat(complete(script, "lightning", "render", script.toString())).isEqualTo(script.toString());
    }

    /** Types lines with a tab in a terminal; the key after it writes the line to a file. */
    private static final String ZSH = """
            zmodload zsh/zpty
            cd $2
            zpty shell zsh -f -i
            zpty -w shell "autoload -U compinit; compinit -u -D; source $1; \
                dump() { print -r -- \\$BUFFER >> out; zle kill-buffer }; zle -N dump; bindkey '^X' dump; echo LOAD''ED"
            zpty -r -m shell text '*LOADED*'
            for line in 'lightning rend' 'lightning render --trad' 'lightning import a --indirect au' 'lightning render my'; do
                zpty -n -w shell "$line"$'\\t\\C-x'
                count=$((count + 1))
                for wait in {1..200}; do
                    [[ -e out && $(wc -l < out) -ge $count ]] && break
                    sleep 0.02
                done
            done
            zpty -d shell
            cat out
            """;

    @Test
    void completion_worksInZsh() throws IOException, InterruptedException {
        Path script = Files.writeString(folder.resolve("script"), CliResult.run("completion", "zsh").assertSuccess().out());
        Files.createDirectory(folder.resolve("my folder"));
        assertThat(runIfInstalled("zsh", "-f", "-c", ZSH, "zsh", script.toString(), folder.toString())).isEqualTo("""
                lightning render\040
                lightning render --traditional\040
                lightning import a --indirect auto\040
                lightning render my\\ folder/
                """);
    }

    @Test
    void completionOfThePackage_worksInZsh_fromTheFirstTab() throws IOException, InterruptedException {
        Path script = Files.writeString(folder.resolve("script"), CliResult.run("completion", "bash").assertSuccess().out());
        Path functions = Files.createDirectory(folder.resolve("functions"));
        Files.createDirectory(folder.resolve("my folder"));
        String installed = "/opt/lightning-relight/share/bash-completion/completions/lightning";
        String function = Files.readString(Path.of("src/main/release/linux/_lightning"));
        assertThat(function).contains(installed);
        Files.writeString(functions.resolve("_lightning"), function.replace(installed, script.toString()));
        String shell = ZSH.replace("autoload -U compinit;", "fpath=(" + functions + " \\$fpath); autoload -U compinit;")
                .replace("source $1;", "");
        assertThat(runIfInstalled("zsh", "-f", "-c", shell, "zsh", script.toString(), folder.toString())).isEqualTo("""
                lightning render\040
                lightning render --traditional\040
                lightning import a --indirect auto\040
                lightning render my\\ folder/
                """);
    }

    private static String complete(Path script, String... words) throws IOException, InterruptedException {
        String line = "source " + script + "; COMP_WORDS=(" + String.join(" ", words) + "); COMP_CWORD=" + (words.length - 1)
                + "; _complete_lightning 2>/dev/null; echo \"${COMPREPLY[*]}\"";
        return runIfInstalled("bash", "-c", line).strip();
    }

    /** Runs a program; returns its output and errors. */
    private static String runIfInstalled(String... words) throws IOException, InterruptedException {
        Process process;
        try {
            process = new ProcessBuilder(words).redirectErrorStream(true).start();
        } catch (IOException e) {
            Assumptions.abort(words[0] + " is not installed");
            throw e;
        }
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(text).isZero();
        return text;
    }
}
