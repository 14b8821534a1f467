package lightning.cli.output;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.base.text.Quote;
import lightning.cli.report.ErrorReport;
import lightning.scene.Scene;
import lightning.scene.SceneWarnings;
import org.jspecify.annotations.Nullable;

/**
 * Output streams of a command.
 *
 * @param out results
 * @param err errors and notes
 * @param terminal true if {@code out} is a terminal
 * @param report what the command reports with {@code --json}
 */
public record Console(PrintStream out, PrintStream err, boolean terminal, CommandReport report) {
    public Console(PrintStream out, PrintStream err, boolean terminal) {
        this(out, err, terminal, new CommandReport());
    }

    /** Returns whether progress can be shown. */
    boolean showsProgress() {
        return terminal && report.printsLines();
    }

    /** Returns a console; it is a terminal only if {@code out} is the process's own output and that is a terminal. */
    public static Console of(PrintStream out, PrintStream err) {
        var console = System.console();
        return new Console(out, err, out == System.out && console != null && console.isTerminal());
    }

    /** Prints one line of results, with locale-independent numbers. */
    public void print(String format, @Nullable Object... values) {
        String text = escapeLines(text(format, values));
        eraseBar();
        if (report.printsLines()) {
            out.println(text);
        } else {
            report.addLine(text);
        }
    }

    /** Prints one note line to the error stream. */
    public void warn(String format, @Nullable Object... values) {
        String text = escapeLines(text(format, values));
        eraseBar();
        if (report.printsLines()) {
            err.println(text);
        } else {
            report.addNote(text);
        }
    }

    /** Prints conversion notes with their counts, one line for each kind, sorted by name. */
    public void printNotes(Path file, String title, Map<String, Integer> counts) {
        counts.entrySet().stream().sorted(Map.Entry.comparingByKey())
                .forEach(note -> warn("%s: %s: %s (%d)", file, title, note.getKey(), note.getValue()));
    }

    /** Prints a note line for each warning about a scene. */
    public void printWarnings(Path file, Scene scene) {
        SceneWarnings.of(scene).forEach(warning -> warn("%s: %s", file, warning));
    }

    /** Prints an error on one line, also if quoted text has line breaks. Also with {@code --quiet} and {@code --json}. */
    public void error(String message) {
        error(new ErrorReport(message));
    }

    /** Prints an error as above; {@code --json} has its place. */
    public void error(ErrorReport error) {
        eraseBar();
        String message = PrintableText.escape(error.message());
        err.println(error.file() == null ? message
                : PrintableText.escape(Quote.path(error.file()) + ":" + error.line() + ":" + error.column() + ": ") + message);
        report.addError(error);
    }

    /** Prints a line that says what to do after an error; it is no error of its own, so {@code --json} leaves it out. */
    public void hint(String text) {
        err.println(PrintableText.escape(text));
    }

    private void eraseBar() {
        report.bar().ifPresent(ProgressBar::erase);
    }

    /** Escapes control characters in each line of a text, so that quoted text cannot control the terminal. */
    private static String escapeLines(String text) {
        return text.lines().map(PrintableText::escape).collect(Collectors.joining("\n"));
    }

    /** Returns a count with its noun, such as "3 lights"; the plural adds an s. */
    public static String count(long number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }

    /** Formats a text, locale-independent; paths are shown by {@link Quote#path}. */
    public static String text(String format, @Nullable Object... values) {
        Object[] shown = Stream.of(values).map(v -> v instanceof Path path ? Quote.path(path) : v).toArray();
        return values.length == 0 ? format : String.format(Locale.ROOT, format, shown);
    }
}
