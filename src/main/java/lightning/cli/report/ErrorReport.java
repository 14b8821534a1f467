package lightning.cli.report;

/**
 * An error.
 *
 * @param message cause, expected and found content, in one line
 * @param file    file with the problem; absent if it is not a place in a file
 * @param line    from 1; absent without a file
 * @param column  from 1; absent without a file
 */
public record ErrorReport(String message, String file, Integer line, Integer column) {
    /** Creates an error without a place. */
    public ErrorReport(String message) {
        this(message, null, null, null);
    }
}
