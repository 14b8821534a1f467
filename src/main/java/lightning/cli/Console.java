package lightning.cli;

import java.io.PrintStream;
import java.util.Locale;

/**
 * Where a command writes to.
 *
 * @param out      results
 * @param err      complaints and remarks
 * @param terminal whether a person watches {@code out}
 */
record Console(PrintStream out, PrintStream err, boolean terminal) {

    /** Recognises the terminal: only there is {@code out} the process's own output and that a terminal's. */
    static Console of(PrintStream out, PrintStream err) {
        var console = System.console();
        return new Console(out, err, out == System.out && console != null && console.isTerminal());
    }

    /** Prints one line of results, numbers as in every locale. */
    void line(String format, Object... values) {
        out.println(text(format, values));
    }

    /** Prints one line of remarks. */
    void remark(String format, Object... values) {
        err.println(text(format, values));
    }

    static String text(String format, Object... values) {
        return values.length == 0 ? format : String.format(Locale.ROOT, format, values);
    }
}
