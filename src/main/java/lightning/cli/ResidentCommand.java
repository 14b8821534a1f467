package lightning.cli;

import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.serve.resident.ResidentClient;
import lightning.serve.resident.ResidentPlace;
import lightning.serve.resident.ResidentServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Runs commands of other processes. */
@Command(name = "resident", header = "Stay and run commands that have --resident.", abbreviateSynopsis = true,
        description = {
            "A command with --resident runs in this process, which has its code compiled already and keeps the last picture: a render of "
                    + "the same scene, or of one that was edited, recomputes only what changed. The files are the same in every byte.",
            "",
            "The first command with --resident starts the process. Only your user can reach it. It serves commands from the same folder, "
                    + "with the same environment and the same program; one that comes from elsewhere replaces it. While it runs a "
                    + "command, others run on their own. It ends when it was idle for some minutes."},
        footer = {
            "Example:",
            "  lightning resident --stop"})
final class ResidentCommand implements Callable<Integer> {
    private static final int DEFAULT_MINUTES = 10;
    private static final int MAX_MINUTES = 24 * 60;

    private final Console console;

    @Spec
    private CommandSpec command;
    @Option(names = "--stop", description = "End the process after the command that it runs.")
    private boolean stop;

    private int minutes = DEFAULT_MINUTES;

    ResidentCommand(Console console) {
        this.console = console;
    }

    @Option(names = "--idle", paramLabel = "MINUTES", description = "Time without a command after which it ends (default: "
            + DEFAULT_MINUTES + ").")
    private void setMinutes(int value) {
        if (value < 1 || value > MAX_MINUTES) {
            throw new ParameterException(command.commandLine(), "--idle must be from 1 to " + MAX_MINUTES + " minutes, was " + value);
        }
        minutes = value;
    }

    @Override
    public Integer call() throws Exception {
        Path socket = ResidentPlace.socket();
        if (stop) {
            console.print(ResidentClient.stop(socket) ? "%s: stopped" : "%s: no process stays", socket);
            return ExitCode.OK;
        }
        try (ResidentCommands commands = new ResidentCommands()) {
            ResidentServer.serve(socket, Duration.ofMinutes(minutes), commands);
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
        return ExitCode.OK;
    }
}
