package lightning.cli.option;

import java.util.List;
import picocli.CommandLine.Option;

/** Option {@code --resident}, which {@code ResidentRun} obeys before a command starts. */
public final class ResidentOption {
    private static final String NAME = "--resident";

    @Option(names = NAME,
            description = "Run in the process of an earlier command with this option, or start one that stays: see 'lightning help "
                    + "resident'. The files are the same.")
    private boolean resident;

    /** Returns whether a command line has the option. */
    public static boolean isIn(List<String> arguments) {
        return arguments.contains(NAME);
    }

    /** Returns a command line without the option. */
    public static List<String> without(List<String> arguments) {
        return arguments.stream().filter(word -> !word.equals(NAME)).toList();
    }
}
