package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** The help of every command. */
public final class HelpPages {
    private HelpPages() {}

    /**
     * The help of one command.
     *
     * @param name as it is typed, from {@code lightning} on
     * @param text with line ends
     */
    public record Page(String name, String text) {}

    /** Returns those of the program, its commands and theirs. */
    public static List<Page> all() {
        List<Page> pages = new ArrayList<>();
        add(commands(), pages);
        return pages;
    }

    private static void add(CommandLine command, List<Page> pages) {
        pages.add(new Page(command.getCommandSpec().qualifiedName(), command.getUsageMessage()));
        command.getSubcommands().values().forEach(one -> add(one, pages));
    }

    /**
     * Returns whether the command that the arguments name has an option.
     *
     * @param arguments without {@code lightning}
     */
    public static boolean hasOption(List<String> arguments, String option) {
        CommandSpec spec = commands().getCommandSpec();
        for (String word : arguments) {
            if (!spec.subcommands().containsKey(word)) {
                break;
            }
            spec = spec.subcommands().get(word).getCommandSpec();
        }
        return spec.findOption(option) != null;
    }

    /** Reads arguments and runs nothing; throws picocli's exceptions where they are wrong. */
    public static void parse(List<String> arguments) {
        commands().parseArgs(arguments.toArray(String[]::new));
    }

    private static CommandLine commands() {
        return Lightning.createCommands(new Console(System.out, System.err, false));
    }
}
