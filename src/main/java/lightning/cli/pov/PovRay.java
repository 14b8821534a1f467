package lightning.cli.pov;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Runs the installed POV-Ray to learn how long it traces. */
public final class PovRay {
    private static final Pattern TRACE_TIME = Pattern.compile("Trace Time:.*\\(([0-9.]+) seconds\\)");

    private final Path program;

    private PovRay(Path program) {
        this.program = program;
    }

    /** The POV-Ray on the search path, if there is one. */
    public static Optional<PovRay> find() {
        return find(System.getenv().getOrDefault("PATH", ""));
    }

    /** The first POV-Ray in a list of folders. */
    static Optional<PovRay> find(String path) {
        return Stream.of(path.split(File.pathSeparator))
                .filter(folder -> !folder.isEmpty()).map(folder -> Path.of(folder, "povray"))
                .filter(Files::isExecutable).findFirst().map(PovRay::new);
    }

    /**
     * Traces a scene, without anti-aliasing, and throws the picture away.
     *
     * @return the trace time that POV-Ray itself tells, milliseconds
     * @throws IOException          if it fails; the message ends with the last line that it printed
     * @throws InterruptedException if this thread was interrupted; POV-Ray is then ended
     */
    public double traceMs(PovScene scene, int width, int height, int threads) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("lightning-pov");
        try {
            scene.write(folder.resolve("scene.pov"));
            return traceMs(folder, List.of(program.toString(), "+Iscene.pov", "+W" + width, "+H" + height, "-A", "+WT" + threads,
                    "-D", "-F"));
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    private static double traceMs(Path folder, List<String> command) throws IOException, InterruptedException {
        Path log = folder.resolve("log");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true)
                .redirectOutput(log.toFile()).start();
        try {
            process.waitFor();
        } finally {
            process.destroy();
        }
        return traceMs(Files.readString(log, StandardCharsets.ISO_8859_1));
    }

    /** Finds the trace time, milliseconds, in what POV-Ray printed. */
    static double traceMs(String log) throws IOException {
        Matcher time = TRACE_TIME.matcher(log);
        if (!time.find()) {
            String last = log.lines().filter(line -> !line.isBlank()).reduce("nothing", (_, line) -> line);
            throw new IOException("POV-Ray told no trace time; it ended with: " + last.strip());
        }
        return 1000 * Double.parseDouble(time.group(1));
    }
}
