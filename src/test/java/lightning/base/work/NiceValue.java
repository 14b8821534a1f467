package lightning.base.work;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Linux's nice value of a thread: the higher, the less processor time. */
public final class NiceValue {
    /** Highest value. */
    public static final int MAX = 19;

    private NiceValue() {}

    /** Returns the nice value of the calling thread: field 19 of its stat file, the 17th after its name. */
    public static int ofThread() {
        try {
            String state = Files.readString(Path.of("/proc/thread-self/stat"));
            return Integer.parseInt(state.substring(state.lastIndexOf(')') + 2).split(" ")[16]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
