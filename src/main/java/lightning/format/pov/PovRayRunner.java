package lightning.format.pov;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.file.SearchPath;
import lightning.base.file.TemporaryFolder;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;

/** Runs the installed POV-Ray to measure its trace time and to get its image. */
public record PovRayRunner(Path program) {
    private static final Pattern TRACE_TIME = Pattern.compile("Trace Time:.*\\(([0-9.]+) seconds\\)");

    /** Finds POV-Ray on the search path. */
    public static Optional<PovRayRunner> find() {
        return find(SearchPath.ofSystem());
    }

    static Optional<PovRayRunner> find(SearchPath path) {
        return path.find("povray").map(PovRayRunner::new);
    }

    /**
     * Traces a scene, without anti-aliasing, and discards the image.
     *
     * @return trace time reported by POV-Ray, in milliseconds
     * @throws IOException if it fails; the message ends with its last output line
     * @throws InterruptedException if this thread was interrupted; POV-Ray is then terminated
     */
    public double traceMs(PovScene scene, int width, int height, int threads) throws IOException, InterruptedException {
        return inTempFolder(scene, folder -> traceMs(folder, command(width, height, threads, PovSampling.NONE, "-F")));
    }

    /**
     * Traces a scene, without anti-aliasing.
     *
     * @return the image, as linear values of its 8-bit codes
     * @throws IOException as {@link #traceMs}
     * @throws InterruptedException as {@link #traceMs}
     */
    public Film render(PovScene scene, int width, int height, int threads) throws IOException, InterruptedException {
        return inTempFolder(scene, folder -> {
            traceMs(folder, command(width, height, threads, PovSampling.NONE, "+FN8", "+Opicture.png"));
            return ImageFile.read(folder.resolve("picture.png"));
        });
    }

    /**
     * Image of a trace.
     *
     * @param film linear values, halves
     * @param ms trace time reported by POV-Ray, in milliseconds
     */
    public record Trace(Film film, double ms) {}

    /**
     * Traces a scene to an OpenEXR image.
     *
     * @throws IOException as {@link #traceMs}
     * @throws InterruptedException as {@link #traceMs}
     */
    public Trace trace(PovScene scene, int width, int height, int threads, PovSampling sampling) throws IOException, InterruptedException {
        return inTempFolder(scene, folder -> {
            double ms = traceMs(folder, command(width, height, threads, sampling, "+FE", "+Opicture.exr"));
            return new Trace(ImageFile.read(folder.resolve("picture.exr")), ms);
        });
    }

    /** Runs a process, and may measure it. */
    public interface ProcessWrapper {
        void run(PovProcess process) throws IOException, InterruptedException;

        /** Process that runs until its end. */
        interface PovProcess {
            void run() throws IOException, InterruptedException;
        }
    }

    /**
     * Traces a scene to a PNG file that is discarded.
     *
     * @param wrapper runs the process while nothing else runs
     * @throws IOException as {@link #traceMs}
     * @throws InterruptedException as {@link #traceMs}
     */
    public void runWrapped(PovScene scene, int width, int height, int threads, PovSampling sampling, ProcessWrapper wrapper)
            throws IOException, InterruptedException {
        inTempFolder(scene, folder -> {
            wrapper.run(() -> traceMs(folder, command(width, height, threads, sampling, "+FN8", "+Opicture.png")));
            return true;
        });
    }

    private List<String> command(int width, int height, int threads, PovSampling sampling, String... output) {
        List<String> words = new ArrayList<>(List.of(program.toString(), "+Iscene.pov", "+W" + width, "+H" + height));
        words.addAll(sampling.arguments());
        words.addAll(List.of("+WT" + threads, "-D"));
        words.addAll(List.of(output));
        return words;
    }

    /** Task on a folder that contains a scene. */
    private interface FolderTask<T> {
        T run(Path folder) throws IOException, InterruptedException;
    }

    private static <T> T inTempFolder(PovScene scene, FolderTask<T> task) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("lightning-pov");
        try {
            scene.write(folder.resolve("scene.pov"));
            return task.run(folder);
        } finally {
            TemporaryFolder.delete(folder);
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

    /** Returns the trace time in milliseconds from POV-Ray's output. */
    static double traceMs(String log) throws IOException {
        Matcher time = TRACE_TIME.matcher(log);
        if (!time.find()) {
            String last = log.lines().filter(line -> !line.isBlank()).reduce("nothing", (_, line) -> line);
            throw new IOException("POV-Ray reported no trace time; its last output was: " + last.strip());
        }
        return 1000 * Double.parseDouble(time.group(1));
    }
}
