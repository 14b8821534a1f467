package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import lightning.cli.output.Console;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;

/** Help pages of all commands. */
public final class HelpPages {
    private HelpPages() {}

    /**
     * Help page of one command.
     *
     * @param name full command name, starting with {@code lightning}
     * @param text text with line ends
     */
    public record Page(String name, String text) {}

    /** Returns the pages of the program and all its commands. */
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

    /** Parses arguments without running a command; throws picocli's exceptions if they are invalid. */
    public static void parse(List<String> arguments) {
        commands().parseArgs(arguments.toArray(String[]::new));
    }

    private static CommandLine commands() {
        return Lightning.createCommands(new Console(System.out, System.err, false));
    }
}
