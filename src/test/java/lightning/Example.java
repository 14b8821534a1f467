package lightning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import lightning.cli.HelpPages;

/**
 * A command that the help or a document shows.
 *
 * @param where     the command whose help shows it, or the document
 * @param arguments without {@code lightning}
 * @param tested    those that a test runs
 * @param exit      the exit code that it promises
 */
record Example(String where, List<String> arguments, List<String> tested, int exit) {
    private static final String BY_MAVEN = "-Dlightning.args=";
    /** Options that every command which has them gets here, in place of what it says itself. */
    private static final Map<String, String> SMALL = Map.of("--size", "60x40", "--repetitions", "1", "--figure", "24");
    private static final List<String> SHORT = List.of("--no-savings", "--quick");
    /** With them others do the work. */
    private static final Set<String> ELSEWHERE = Set.of("--cluster", "--certificate", "--bind");

    /** Returns those of the help of all commands: the lines that two spaces and the program's name begin. */
    static List<Example> ofHelp() {
        List<Example> all = new ArrayList<>();
        for (HelpPages.Page page : HelpPages.all()) {
            page.text().lines().filter(line -> line.startsWith("  lightning ")).map(line -> of(page.name(), line)).forEach(all::add);
        }
        return all;
    }

    /** Returns those that a document shows indented: they name files of a user's own, or take long. */
    static List<Example> indentedIn(String document, String markdown) {
        return markdown.lines().filter(line -> line.startsWith("    lightning ")).map(line -> of(document, line)).toList();
    }

    private static Example of(String where, String line) {
        List<String> words = DocCommands.words(line);
        List<String> arguments = words.subList(1, words.size());
        return new Example(where, arguments, small(arguments), 0);
    }

    /** Returns those in the blocks of a document for a shell, which run as they stand, also those that Maven hands on. */
    static List<Example> inBlocksOf(String document, String markdown) {
        List<Example> all = new ArrayList<>();
        for (DocCommands.Command command : DocCommands.of(markdown)) {
            Stream<List<String>> arguments = command.name().equals("lightning") ? Stream.of(command.arguments())
                    : command.words().stream().filter(word -> word.startsWith(BY_MAVEN))
                            .map(word -> DocCommands.words(word.substring(BY_MAVEN.length())));
            arguments.forEach(words -> all.add(new Example(document, words, words, command.exit())));
        }
        return all;
    }

    /** Whether it would open a window or wait for others. */
    boolean goesOn() {
        return arguments.getFirst().equals("edit") || arguments.getFirst().equals("node") && arguments.contains("--bind");
    }

    /** Whether it may end with 1 too: times, and what it compares with, are as they are. */
    boolean mayFailItsCheck() {
        return arguments.contains("--baseline");
    }

    /** The same arguments on this machine, at a small size, and with nothing measured for long. */
    static List<String> small(List<String> arguments) {
        boolean atPixel = arguments.getFirst().equals("explain");
        var words = new ArrayList<String>();
        for (int i = 0; i < arguments.size(); i++) {
            if (ELSEWHERE.contains(arguments.get(i)) || SMALL.containsKey(arguments.get(i)) && !atPixel) {
                i++;
            } else if (!SHORT.contains(arguments.get(i))) {
                words.add(arguments.get(i));
            }
        }
        if (!atPixel) {
            SMALL.forEach((option, value) -> {
                if (HelpPages.hasOption(arguments, option)) {
                    words.addAll(List.of(option, value));
                }
            });
        }
        SHORT.stream().filter(option -> HelpPages.hasOption(arguments, option)).forEach(words::add);
        return words;
    }
}
