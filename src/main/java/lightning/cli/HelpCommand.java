package lightning.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.format.jen.asset.NameSuggestion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Prints the help of a command, or writes the manual pages of all commands. */
@Command(name = "help", abbreviateSynopsis = true, header = "Show the help of a command.",
        description = "Same as --help after the command. With --man, writes a manual page of each command for the program man.",
        footer = {
            "Examples:",
            "  lightning help render",
            "  lightning help shot relight",
            "  lightning help --man man1"})
final class HelpCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(paramLabel = "COMMAND", arity = "0..*", description = "Command (default: the program).")
    private List<String> words = List.of();
    @Option(names = "--man", paramLabel = "FOLDER", description = "Write manual pages to a folder, created if missing.")
    private @Nullable Path manual;
    @Option(names = "--completion", paramLabel = "FOLDER", hidden = true,
            description = "Write the script for bash, under the program's name, to a folder.")
    private @Nullable Path completion;

    HelpCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        CommandLine commands = Lightning.createCommands(console);
        if (manual != null) {
            Files.createDirectories(manual);
            writeManual(manual, commands);
        }
        if (completion != null) {
            Files.createDirectories(completion);
            write(completion.resolve("lightning"), CompletionCommand.script(console));
        }
        if (manual != null || completion != null) {
            return ExitCode.OK;
        }
        CommandLine command = commands;
        for (String word : words) {
            Map<String, CommandLine> next = command.getSubcommands();
            if (!next.containsKey(word)) {
                throw new BadInputException("no command " + Quote.of(word) + " of " + command.getCommandSpec().qualifiedName()
                        + NameSuggestion.hint(word, next.keySet()));
            }
            command = next.get(word);
        }
        command.usage(command.getOut());
        return ExitCode.OK;
    }

    private void writeManual(Path to, CommandLine command) throws IOException {
        var page = new ManualPage(command);
        write(to.resolve(page.fileName()), page.text());
        for (CommandLine next : command.getSubcommands().values()) {
            writeManual(to, next);
        }
    }

    private static void write(Path file, String text) throws IOException {
        AtomicFile.of(file).write(text.getBytes(StandardCharsets.UTF_8));
    }
}
