package lightning.format.pov;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;

/** Runs the installed POV-Ray to learn how long it traces, and what it shows. */
public final class PovRayRunner {
    private static final Pattern TRACE_TIME = Pattern.compile("Trace Time:.*\\(([0-9.]+) seconds\\)");

    private final Path program;

    private PovRayRunner(Path program) {
        this.program = program;
    }

    /** The POV-Ray on the search path, if there is one. */
    public static Optional<PovRayRunner> find() {
        return find(System.getenv().getOrDefault("PATH", ""));
    }

    /** The first POV-Ray in a list of folders. */
    static Optional<PovRayRunner> find(String path) {
        return Stream.of(path.split(File.pathSeparator))
                .filter(folder -> !folder.isEmpty()).map(folder -> Path.of(folder, "povray"))
                .filter(Files::isExecutable).findFirst().map(PovRayRunner::new);
    }

    /**
     * Traces a scene, without anti-aliasing, and throws the picture away.
     *
     * @return the trace time that POV-Ray itself tells, milliseconds
     * @throws IOException          if it fails; the message ends with the last line that it printed
     * @throws InterruptedException if this thread was interrupted; POV-Ray is then ended
     */
    public double traceMs(PovScene scene, int width, int height, int threads) throws IOException, InterruptedException {
        return inTempFolder(scene, folder -> traceMs(folder, command(width, height, threads, "-F")));
    }

    /**
     * Traces a scene, without anti-aliasing.
     *
     * @return the picture that POV-Ray wrote, in the linear values that its 8-bit codes display
     * @throws IOException          as {@link #traceMs}
     * @throws InterruptedException as {@link #traceMs}
     */
    public Film render(PovScene scene, int width, int height, int threads) throws IOException, InterruptedException {
        return inTempFolder(scene, folder -> {
            traceMs(folder, command(width, height, threads, "+FN8", "+Opicture.png"));
            return ImageFile.read(folder.resolve("picture.png"));
        });
    }

    /** Runs a process, and may measure it. */
    public interface ProcessWrapper {
        void run(PovProcess process) throws IOException, InterruptedException;

        /** Starts the process and waits for its end. */
        interface PovProcess {
            void run() throws IOException, InterruptedException;
        }
    }

    /**
     * Traces a scene, without anti-aliasing, into a PNG file that nobody reads.
     *
     * @param wrapper runs the process: nothing else is done then
     * @throws IOException          as {@link #traceMs}
     * @throws InterruptedException as {@link #traceMs}
     */
    public void runWrapped(PovScene scene, int width, int height, int threads, ProcessWrapper wrapper)
            throws IOException, InterruptedException {
        inTempFolder(scene, folder -> {
            wrapper.run(() -> traceMs(folder, command(width, height, threads, "+FN8", "+Opicture.png")));
            return null;
        });
    }

    private List<String> command(int width, int height, int threads, String... output) {
        List<String> arguments = new ArrayList<>(List.of(program.toString(), "+Iscene.pov", "+W" + width, "+H" + height, "-A",
                "+WT" + threads, "-D"));
        arguments.addAll(List.of(output));
        return arguments;
    }

    /** What is done with a folder that holds a scene. */
    private interface FolderTask<T> {
        T run(Path folder) throws IOException, InterruptedException;
    }

    private static <T> T inTempFolder(PovScene scene, FolderTask<T> task) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("lightning-pov");
        try {
            scene.write(folder.resolve("scene.pov"));
            return task.run(folder);
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
