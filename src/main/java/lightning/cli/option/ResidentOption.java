package lightning.cli.option;

import java.util.List;
import java.util.Set;
import picocli.CommandLine.Option;

/** Option {@code --resident}, which {@code ResidentRun} obeys before a command starts. */
public final class ResidentOption {
    private static final String NAME = "--resident";
    private static final Set<String> COMMANDS = Set.of("render", "relight", "shot");

    @Option(names = NAME,
            description = "Run in the process of an earlier command with this option, or start one that stays: see 'lightning help "
                    + "resident'. The files are the same.")
    private boolean resident;

    /**
     * Returns whether a command line runs in the resident process. One with a cluster does not: its process reads no objects from the network, which
     * only the launcher can ensure.
     */
    public static boolean appliesTo(List<String> arguments) {
        return !arguments.isEmpty() && COMMANDS.contains(arguments.getFirst()) && arguments.contains(NAME)
                && arguments.stream().noneMatch(word -> word.startsWith("--cluster"));
    }

    /** Returns a command line without the option. */
    public static List<String> without(List<String> arguments) {
        return arguments.stream().filter(word -> !word.equals(NAME)).toList();
    }
}
