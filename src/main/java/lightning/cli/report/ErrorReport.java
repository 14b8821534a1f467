package lightning.cli.report;

import org.jspecify.annotations.Nullable;

/**
 * An error.
 *
 * @param message cause, expected and found content, in one line
 * @param file    file with the problem; absent if it is not a place in a file
 * @param line    from 1; absent without a file
 * @param column  from 1; absent without a file
 */
public record ErrorReport(String message, @Nullable String file, @Nullable Integer line, @Nullable Integer column) {
    /** Creates an error without a place. */
    public ErrorReport(String message) {
        this(message, null, null, null);
    }
}
