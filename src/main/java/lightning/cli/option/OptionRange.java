package lightning.cli.option;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/** Range of the numbers that an option takes. */
public final class OptionRange {
    private OptionRange() {}

    /**
     * Returns a number that is within its range.
     *
     * @param option name of the option in the message
     * @throws ParameterException if the number is outside
     */
    public static int check(CommandSpec command, String option, int value, int min, int max) {
        if (value < min || value > max) {
            throw new ParameterException(command.commandLine(), option + " must be from " + min + " to " + max + ", was " + value);
        }
        return value;
    }
}
