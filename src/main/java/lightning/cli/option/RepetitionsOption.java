package lightning.cli.option;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Option {@code --repetitions}. */
public final class RepetitionsOption {
    private static final int MAX_REPETITIONS = 1000;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    private int repetitions = 5;

    @Option(names = "--repetitions", paramLabel = "N", description = "Repetitions of each measurement (default: 5).")
    private void setRepetitions(int value) {
        repetitions = requireValid(command, value);
    }

    /** Returns the number, or throws if it is out of range. */
    public static int requireValid(CommandSpec command, int value) {
        if (value < 1 || value > MAX_REPETITIONS) {
            throw new ParameterException(command.commandLine(), "--repetitions must be from 1 to " + MAX_REPETITIONS + ", was " + value);
        }
        return value;
    }

    public int count() {
        return repetitions;
    }
}
