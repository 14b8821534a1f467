package lightning.cli.report;

import java.io.PrintStream;
import java.util.List;
import lightning.format.json.ReportMapper;
import org.jspecify.annotations.Nullable;

/**
 * The JSON object that a command prints with {@code --json}.
 *
 * @param command  full name without {@code lightning}, such as {@code shot render}
 * @param exitCode exit code of the process
 * @param result   record of the command; absent if it failed before its end
 * @param text     lines of a command without a record, in order; absent otherwise
 * @param notes    lines that the command prints to the error stream without {@code --json}
 * @param errors   errors, in order; empty if the command succeeded
 */
public record JsonOutput(String command, int exitCode, @Nullable Object result, @Nullable List<String> text, List<String> notes,
        List<ErrorReport> errors) {
    /** Prints the object and a line end. */
    public void print(PrintStream out) {
        out.println(ReportMapper.MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(this));
    }
}
