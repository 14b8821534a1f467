package lightning;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Commands in a documentation page: the lines of its fenced {@code sh} blocks. A line that ends with a backslash continues in the next one;
 * a comment ends a line.
 */
final class DocCommands {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```sh\\s*?\\n(.*?)^```");
    private static final Pattern WORD = Pattern.compile("\\s*((?:\"[^\"]*\"|'[^']*'|[^\\s\"'])+)");
    private static final Pattern EXIT = Pattern.compile("#.*\\bexit (\\d+)\\b");

    /**
     * Command.
     *
     * @param words name and arguments, without quotes
     * @param exit  exit code in its comment ("# exit 2"), else 0
     */
    record Command(List<String> words, int exit) {
        String name() {
            return words.getFirst();
        }

        List<String> arguments() {
            return words.subList(1, words.size());
        }
    }

    private DocCommands() {}

    /** Returns the commands of the page in order. */
    static List<Command> of(String markdown) {
        List<Command> commands = new ArrayList<>();
        Matcher block = BLOCK.matcher(markdown);
        while (block.find()) {
            for (String line : block.group(1).replaceAll("\\\\\\n\\s*", " ").split("\\n")) {
                List<String> words = words(line);
                if (!words.isEmpty()) {
                    Matcher exit = EXIT.matcher(line);
                    commands.add(new Command(words, exit.find() ? Integer.parseInt(exit.group(1)) : 0));
                }
            }
        }
        return commands;
    }

    /** Splits a command line as a shell does, with quotes and comments. */
    static List<String> words(String line) {
        List<String> words = new ArrayList<>();
        Matcher word = WORD.matcher(line);
        while (word.lookingAt()) {
            if (word.group(1).startsWith("#")) {
                break;
            }
            words.add(word.group(1).replaceAll("\"([^\"]*)\"|'([^']*)'", "$1$2"));
            word.region(word.end(), line.length());
        }
        return List.copyOf(words);
    }
}
