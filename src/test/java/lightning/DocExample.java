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
 * @param source     the command whose help shows it, or the document
 * @param arguments without {@code lightning}
 * @param testArguments    those that a test runs
 * @param exit      the exit code that it promises
 */
record DocExample(String source, List<String> arguments, List<String> testArguments, int exit) {
    private static final String MAVEN_ARGUMENTS = "-Dlightning.args=";
    /** Options that every command which has them gets here, in place of what it says itself. */
    private static final Map<String, String> SMALL_OPTIONS = Map.of("--size", "60x40", "--repetitions", "1", "--figure", "24");
    private static final List<String> SHORT_OPTIONS = List.of("--no-savings", "--quick");
    /** With them others do the work. */
    private static final Set<String> CLUSTER_OPTIONS = Set.of("--cluster", "--certificate", "--bind");

    /** Returns those of the help of all commands: the lines that two spaces and the program's name begin. */
    static List<DocExample> fromHelp() {
        List<DocExample> all = new ArrayList<>();
        for (HelpPages.Page page : HelpPages.all()) {
            page.text().lines().filter(line -> line.startsWith("  lightning ")).map(line -> of(page.name(), line)).forEach(all::add);
        }
        return all;
    }

    /** Returns those that a document shows indented: they name files of a user's own, or take long. */
    static List<DocExample> fromIndentedLines(String document, String markdown) {
        return markdown.lines().filter(line -> line.startsWith("    lightning ")).map(line -> of(document, line)).toList();
    }

    private static DocExample of(String where, String line) {
        List<String> words = DocCommands.words(line);
        List<String> arguments = words.subList(1, words.size());
        return new DocExample(where, arguments, shrink(arguments), 0);
    }

    /** Returns those in the blocks of a document for a shell, which run as they stand, also those that Maven hands on. */
    static List<DocExample> inBlocks(String document, String markdown) {
        List<DocExample> all = new ArrayList<>();
        for (DocCommands.Command command : DocCommands.of(markdown)) {
            Stream<List<String>> arguments = command.name().equals("lightning") ? Stream.of(command.arguments())
                    : command.words().stream().filter(word -> word.startsWith(MAVEN_ARGUMENTS))
                            .map(word -> DocCommands.words(word.substring(MAVEN_ARGUMENTS.length())));
            arguments.forEach(words -> all.add(new DocExample(document, words, words, command.exit())));
        }
        return all;
    }

    /** Whether it would open a window or wait for others. */
    boolean runsUntilStopped() {
        return arguments.getFirst().equals("edit") || arguments.getFirst().equals("node") && arguments.contains("--bind");
    }

    /** Whether it may end with 1 too: times, and what it compares with, are as they are. */
    boolean mayFailCheck() {
        return arguments.contains("--baseline");
    }

    /** The same arguments on this machine, at a small size, and with nothing measured for long. */
    static List<String> shrink(List<String> arguments) {
        boolean atPixel = arguments.getFirst().equals("explain");
        var words = new ArrayList<String>();
        for (int i = 0; i < arguments.size(); i++) {
            if (CLUSTER_OPTIONS.contains(arguments.get(i)) || SMALL_OPTIONS.containsKey(arguments.get(i)) && !atPixel) {
                i++;
            } else if (!SHORT_OPTIONS.contains(arguments.get(i))) {
                words.add(arguments.get(i));
            }
        }
        if (!atPixel) {
            SMALL_OPTIONS.forEach((option, value) -> {
                if (HelpPages.hasOption(arguments, option)) {
                    words.addAll(List.of(option, value));
                }
            });
        }
        SHORT_OPTIONS.stream().filter(option -> HelpPages.hasOption(arguments, option)).forEach(words::add);
        return words;
    }
}
