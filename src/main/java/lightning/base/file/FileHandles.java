package lightning.base.file;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;

/** Check for exhausted file handles. */
public final class FileHandles {
    /** The system's message in English. */
    private static final String MESSAGE = "Too many open files";
    /** A file that every Java runtime has. */
    private static final File PROBE_FILE = new File(System.getProperty("java.home"), "release");

    /** Number of free handles that Java needs to load one of its providers. */
    private static final int MIN_FREE = 16;

    private FileHandles() {}

    /** Returns whether a lack of file handles caused a problem: its message says so, or almost none are free. */
    public static boolean areExhausted(Throwable problem) {
        for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
            if (cause.getMessage() != null && cause.getMessage().contains(MESSAGE)) {
                return true;
            }
        }
        return !canOpen(MIN_FREE);
    }

    /** Opens one file after the other, because the failed operation may have released handles. */
    private static boolean canOpen(int count) {
        if (count == 0) {
            return true;
        }
        try (var _ = new FileInputStream(PROBE_FILE)) {
            return canOpen(count - 1);
        } catch (IOException e) {
            return !PROBE_FILE.exists();
        }
    }
}
