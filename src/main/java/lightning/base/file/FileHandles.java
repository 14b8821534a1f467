package lightning.base.file;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;

/** Tells when a process has used up the file handles that the system grants it. */
public final class FileHandles {
    /** What the system says, unless it speaks another language. */
    private static final String MESSAGE = "Too many open files";
    /** A file that every Java has. */
    private static final File PROBE_FILE = new File(System.getProperty("java.home"), "release");

    /** Fewer free handles than Java takes to load a provider of its own. */
    private static final int MIN_FREE = 16;

    private FileHandles() {}

    /** Returns whether a lack of file handles caused a problem: the problem says so, or almost none are left. */
    public static boolean areExhausted(Throwable problem) {
        for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
            if (cause.getMessage() != null && cause.getMessage().contains(MESSAGE)) {
                return true;
            }
        }
        return !canOpen(MIN_FREE);
    }

    /** Opens one after the other, as what failed may have given some back. */
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
