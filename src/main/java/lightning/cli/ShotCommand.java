package lightning.cli;

import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Parent of the commands for the frames of a shot. */
@Command(name = "shot", abbreviateSynopsis = true, header = "Render or relight the frames of a shot.",
        description = "A scene with a shot block has one image per frame.",
        footer = {
            "Example:",
            "  lightning shot render scenes/dusk.jen -o frames"})
final class ShotCommand implements Callable<Integer> {
    @Spec
    private CommandSpec command;

    @Override
    public Integer call() {
        throw new ParameterException(command.commandLine(), "expected a subcommand of shot: "
                + String.join(", ", command.subcommands().keySet()));
    }
}
