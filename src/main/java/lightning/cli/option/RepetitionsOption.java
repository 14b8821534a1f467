package lightning.cli.option;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Option {@code --repetitions}. */
public final class RepetitionsOption {
    private static final int MAX_REPETITIONS = 1000;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    private int repetitions = 5;

    @Option(names = "--repetitions", paramLabel = "N", description = "Repetitions of each measurement (default: 5).")
    private void setRepetitions(int value) {
        repetitions = check(command, value);
    }

    /** Returns the number, or throws if it is out of range. */
    public static int check(CommandSpec command, int value) {
        return OptionRange.check(command, "--repetitions", value, 1, MAX_REPETITIONS);
    }

    public int count() {
        return repetitions;
    }
}
