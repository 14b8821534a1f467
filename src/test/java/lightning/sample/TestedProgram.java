package lightning.sample;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Command lines of processes that run the classes under test. */
public final class TestedProgram {
    private TestedProgram() {}

    /**
     * Returns a command, to which words can be added, that starts the program in any folder. The processes are short, so the second compiler
     * would not pay.
     *
     * @param options of Java, such as {@code -Xmx600m}
     */
    public static List<String> command(String... options) {
        return ofClass("lightning.Main", options);
    }

    /** Returns the same for another class with a main method. */
    public static List<String> ofClass(String mainClass, String... options) {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "--add-modules", "jdk.incubator.vector",
                "--enable-native-access=ALL-UNNAMED"));
        line.addAll(List.of(options));
        line.addAll(List.of("-cp", classPath(), mainClass));
        return line;
    }

    private static String classPath() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
                .map(entry -> Path.of(entry).toAbsolutePath().toString()).collect(Collectors.joining(File.pathSeparator));
    }
}
