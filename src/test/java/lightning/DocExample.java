package lightning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import lightning.cli.HelpPages;

/**
 * Example command from the help or a document.
 *
 * @param source        the command whose help shows it, or the document
 * @param arguments     arguments without {@code lightning}
 * @param testArguments arguments that a test runs
 * @param exit          expected exit code
 */
record DocExample(String source, List<String> arguments, List<String> testArguments, int exit) {
    private static final String MAVEN_ARGUMENTS = "-Dlightning.args=";
    /** Options replaced in every command that has them. */
    private static final Map<String, String> SMALL_OPTIONS = Map.of("--size", "60x40", "--repetitions", "1", "--figure", "24");
    private static final List<String> SHORT_OPTIONS = List.of("--no-savings", "--quick");
    /** Options with which other machines do the work. */
    private static final Set<String> CLUSTER_OPTIONS = Set.of("--cluster", "--certificate", "--bind");

    /** Returns the examples in the help of all commands: lines that begin with two spaces and the program's name. */
    static List<DocExample> fromHelp() {
        List<DocExample> all = new ArrayList<>();
        for (HelpPages.Page page : HelpPages.all()) {
            page.text().lines().filter(line -> line.startsWith("  lightning ")).map(line -> of(page.name(), line)).forEach(all::add);
        }
        return all;
    }

    /** Returns the indented examples of a document: they name a user's own files, or take long. */
    static List<DocExample> fromIndentedLines(String document, String markdown) {
        return markdown.lines().filter(line -> line.startsWith("    lightning ")).map(line -> of(document, line)).toList();
    }

    private static DocExample of(String where, String line) {
        List<String> words = DocCommands.words(line);
        List<String> arguments = words.subList(1, words.size());
        return new DocExample(where, arguments, shrink(arguments), 0);
    }

    /** Returns the examples in a document's shell blocks, which run unchanged, including examples that Maven runs. */
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

    /** Returns whether it opens a window or waits for other processes. */
    boolean runsUntilStopped() {
        return arguments.getFirst().equals("edit") || arguments.getFirst().equals("serve")
                || arguments.getFirst().equals("node") && arguments.contains("--bind") || arguments.contains("--live");
    }

    /** Returns whether exit code 1 is also accepted, because its check depends on times or compared files. */
    boolean mayFailCheck() {
        return arguments.contains("--baseline");
    }

    /** Returns the example with a small size and no long measurements. */
    DocExample small() {
        return new DocExample(source, arguments, shrink(arguments), exit);
    }

    /** Returns the arguments for a fast run on this machine: a small size and no long measurements. */
    static List<String> shrink(List<String> arguments) {
        boolean atPixel = arguments.getFirst().equals("explain") || arguments.contains("--crop");
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
