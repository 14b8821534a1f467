package lightning.cli;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;

/**
 * Where a command writes to.
 *
 * @param out      results
 * @param err      complaints and remarks
 * @param terminal whether a person watches {@code out}
 */
record Console(PrintStream out, PrintStream err, boolean terminal) {

    /** Recognizes the terminal: only there is {@code out} the process's own output and that a terminal's. */
    static Console of(PrintStream out, PrintStream err) {
        var console = System.console();
        return new Console(out, err, out == System.out && console != null && console.isTerminal());
    }

    /** Prints one line of results, numbers as in every locale. */
    void print(String format, Object... values) {
        out.println(escapeLines(text(format, values)));
    }

    /** Prints one line of remarks. */
    void warn(String format, Object... values) {
        err.println(escapeLines(text(format, values)));
    }

    /** Prints what is not the same in a file and how often, a line for each kind in the order of their names. */
    void printNotes(Path file, String title, Map<String, Integer> counts) {
        counts.entrySet().stream().sorted(Map.Entry.comparingByKey())
                .forEach(note -> warn("%s: %s: %s (%d)", file, title, note.getKey(), note.getValue()));
    }

    /** Prints a complaint, one line whatever is quoted in it. */
    void error(String message) {
        err.println(PrintableText.escape(message));
    }

    /** The lines of a text without a character that would steer the terminal. */
    private static String escapeLines(String text) {
        return text.lines().map(PrintableText::escape).collect(Collectors.joining("\n"));
    }

    /** As in "3 lights"; of nouns that take an s. */
    static String count(long number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }

    /** Fills in a format; files stand in it as {@link Quote#path} shows them. */
    static String text(String format, Object... values) {
        Object[] shown = Stream.of(values).map(v -> v instanceof Path path ? Quote.path(path) : v).toArray();
        return values.length == 0 ? format : String.format(Locale.ROOT, format, shown);
    }
}
