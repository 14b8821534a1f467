package lightning.cli.output;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.cli.report.ErrorReport;
import lightning.cli.report.JsonOutput;
import org.jspecify.annotations.Nullable;

/** Report of one run of the program: as lines, as one JSON object at its end ({@code --json}), or none ({@code --quiet}). */
public final class CommandReport {
    private boolean json;
    private boolean quiet;
    private @Nullable Object result;
    private @Nullable ProgressBar bar;
    private final List<String> lines = new ArrayList<>();
    private final List<String> notes = new ArrayList<>();
    private final List<ErrorReport> errors = new ArrayList<>();

    public synchronized void useJson() {
        json = true;
    }

    public synchronized void beQuiet() {
        quiet = true;
    }

    public synchronized boolean isJson() {
        return json;
    }

    /** Sets the progress bar on the terminal, which each line replaces. */
    synchronized void setBar(@Nullable ProgressBar shown) {
        bar = shown;
    }

    synchronized Optional<ProgressBar> bar() {
        return Optional.ofNullable(bar);
    }

    /** Returns whether lines are printed when they arise. */
    synchronized boolean printsLines() {
        return !json && !quiet;
    }

    synchronized void addLine(String line) {
        lines.add(line);
    }

    synchronized void addNote(String note) {
        notes.add(note);
    }

    synchronized void addError(ErrorReport error) {
        errors.add(error);
    }

    /** Sets the record of the command, which {@code --json} prints. */
    public synchronized void setResult(Object value) {
        result = value;
    }

    /** Prints the JSON object. */
    public synchronized void print(PrintStream out, String command, int exitCode) {
        boolean hasText = result == null && !lines.isEmpty();
        new JsonOutput(command, exitCode, result, hasText ? lines : null, notes, errors).print(out);
    }
}
