package lightning.cli.output;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;

/** Test for a pipe whose reader has ended, such as that of {@code lightning completion | head}. */
public final class ClosedPipe {
    private ClosedPipe() {}

    /**
     * Returns whether a stream that failed is the process's own output and its reader has ended. That is no error: Unix programs end
     * without a message then.
     */
    @SuppressWarnings("resource") // The descriptor belongs to the process.
    public static boolean isOutput(PrintStream out) {
        if (out != System.out) {
            return false;
        }
        try {
            // A print stream stores that a write failed, but not why; a closed pipe fails again.
            new FileOutputStream(FileDescriptor.out).write('\n');
            return false;
        } catch (IOException e) {
            // Other languages add the English words in parentheses.
            return String.valueOf(e.getMessage()).toLowerCase(Locale.ROOT).contains("broken pipe");
        }
    }
}
