package lightning.base.file;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** Files of which the running program consists. */
public final class ProgramFiles {
    private ProgramFiles() {}

    /** Returns whether all are archives, whose state tells their content. */
    public static boolean areArchives() {
        return files().stream().allMatch(Files::isRegularFile);
    }

    /** Returns the version of Java, and the name, size and time of each file of the program. */
    public static String state() throws IOException {
        var text = new StringBuilder(Runtime.version().toString());
        for (Path file : files()) {
            text.append('\n').append(file);
            if (Files.exists(file)) {
                text.append(' ').append(Files.size(file)).append(' ').append(Files.getLastModifiedTime(file));
            }
        }
        return text.toString();
    }

    private static List<Path> files() {
        String path = System.getProperty("jdk.module.path", System.getProperty("java.class.path"));
        return Arrays.stream(path.split(File.pathSeparator, -1)).map(name -> Path.of(name).toAbsolutePath()).toList();
    }
}
