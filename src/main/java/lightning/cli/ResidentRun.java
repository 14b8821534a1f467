package lightning.cli;

import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import lightning.base.file.FileErrorMessage;
import lightning.base.process.OwnProgram;
import lightning.cli.option.ResidentOption;
import lightning.cli.output.Console;
import lightning.cli.output.ErrorReporter;
import lightning.serve.resident.ResidentClient;
import lightning.serve.resident.ResidentPlace;

/** Runs a command in the resident process if the command line has the option, else in this process. */
public final class ResidentRun {
    private ResidentRun() {}

    /** As {@link Lightning#run}. */
    public static int run(PrintStream out, PrintStream err, String... args) {
        List<String> arguments = List.of(args);
        if (!ResidentOption.appliesTo(arguments)) {
            return Lightning.run(out, err, args);
        }
        List<String> command = ResidentOption.without(arguments);
        Console console = Console.of(out, err);
        String reason;
        try {
            OptionalInt exit = new ResidentClient(ResidentPlace.socket(), ResidentRun::start)
                    .run(out, err, console.terminal(), command);
            if (exit.isPresent()) {
                return Lightning.checkOutput(console, exit.getAsInt());
            }
            reason = "it runs another command";
        } catch (CancellationException e) {
            return ErrorReporter.report(console, e);
        } catch (IOException e) {
            reason = FileErrorMessage.of(e);
        }
        err.println("lightning: without the resident process: " + reason);
        return Lightning.run(out, err, command.toArray(String[]::new));
    }

    /** Starts a process that survives Ctrl-C in this terminal. */
    private static Process start() throws IOException {
        List<String> command = new ArrayList<>();
        if (!System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows")) {
            // Programs keep ignoring a signal that they were started with ignored.
            command.addAll(List.of("/bin/sh", "-c", "trap '' INT HUP; exec \"$@\"", "sh"));
        }
        command.addAll(OwnProgram.command());
        command.add("resident");
        return new ProcessBuilder(command).redirectInput(ProcessBuilder.Redirect.PIPE)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }
}
