package lightning.cli;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The option {@code --repetitions}. */
final class RepetitionsOption {
    private static final int MAX_REPETITIONS = 1000;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    private int repetitions = 5;

    @Option(names = "--repetitions", paramLabel = "N", description = "How often each is measured; 5 without it.")
    private void setRepetitions(int value) {
        repetitions = requireValid(command, value);
    }

    /** The number, if it is one that can be asked for. */
    static int requireValid(CommandSpec command, int value) {
        if (value < 1 || value > MAX_REPETITIONS) {
            throw new ParameterException(command.commandLine(), "--repetitions must be from 1 to " + MAX_REPETITIONS + ", was " + value);
        }
        return value;
    }

    int count() {
        return repetitions;
    }
}
