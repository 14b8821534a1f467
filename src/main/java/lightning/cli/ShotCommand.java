package lightning.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** What is done with the frames of a shot. */
@Command(name = "shot", abbreviateSynopsis = true, header = "Render the frames of a shot, or relight them.",
        description = {"A scene with a shot block has a picture for each frame."},
        footer = {
            "Example:",
            "  lightning shot render scenes/dusk.jen -o frames"})
final class ShotCommand implements Callable<Integer> {
    @Spec
    private CommandSpec command;

    @Override
    public Integer call() {
        throw new ParameterException(command.commandLine(), "expected what to do with the shot, which can be: "
                + String.join(", ", command.subcommands().keySet()));
    }
}
