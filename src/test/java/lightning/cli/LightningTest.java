package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import lightning.cli.output.Console;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;

class LightningTest {
    @TempDir
    Path folder;

    static Set<String> names() {
        return commands().getSubcommands().keySet();
    }

    private static CommandLine commands() {
        return Lightning.createCommands(new Console(System.out, System.err, false));
    }

    @Test
    void help_listsEveryCommand() {
        CliResult help = CliResult.run("--help").assertSuccess();
        assertThat(help.out()).contains(names());
        assertThat(names()).contains("render", "relight", "export", "effects", "explain", "check", "compare", "tour");
    }

    @ParameterizedTest
    @MethodSource("names")
    void singleCommand_isCreatedAlone(String name) {
        CommandLine alone = Lightning.createCommands(new Console(System.out, System.err, false), name, "--help");
        assertThat(alone.getSubcommands()).containsOnlyKeys(name);
        assertThat(alone.getSubcommands().get(name).getUsageMessage())
                .isEqualTo(commands().getSubcommands().get(name).getUsageMessage());
    }

    @Test
    void version_showsProgramAndJava() {
        assertThat(CliResult.run("--version").assertSuccess().out()).startsWith("Lightning ").contains("Java " + Runtime.version());
    }

    @Test
    void unknownCommand_isRejectedWithList() {
        CliResult.run("rendr", "a.jen", "-o", "b.png").assertRejected("unknown command 'rendr'", "render, relight");
    }

    @ParameterizedTest
    @MethodSource("names")
    void unknownOption_isRejected(String name) {
        CliResult.run(name, "--nonsense").assertRejected("lightning " + name + ": ", "Try 'lightning " + name + " --help'");
    }

    @Test
    void missingScene_isReportedByName() {
        CliResult.run("check", folder.resolve("no.jen")).assertRejected(folder.resolve("no.jen") + ": file not found");
    }

    @Test
    void folderAsScene_isRejected() {
        CliResult.run("check", folder).assertRejected(folder + ": is a folder");
    }

    @Test
    void sceneWithoutCommand_runsTour() throws Exception {
        CliResult tour = CliResult.run(Files.writeString(folder.resolve("bad.jen"), "jen 2"));
        assertThat(tour.exit()).isEqualTo(2);
        assertThat(tour.err()).startsWith("The editor cannot open a window here").contains("bad.jen:1:5");
    }

    @Test
    void internalErrors_exitWithCode2() {
        var throwing = new PrintStream(PrintStream.nullOutputStream(), false, StandardCharsets.UTF_8) {
            @Override
            public void println(String line) {
                throw new IllegalStateException("wrong");
            }
        };
        var err = new ByteArrayOutputStream();
        assertThat(Lightning.run(throwing, new PrintStream(err, true, StandardCharsets.UTF_8), "check", "scenes/bird.jen")).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).hasLineCount(1).contains("internal error", "wrong",
                "please report it");
    }
}
