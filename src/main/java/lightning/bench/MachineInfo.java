package lightning.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import jdk.incubator.vector.FloatVector;
import lightning.base.file.ParentFolder;
import lightning.bench.result.MachineSpec;

/** Information about the current machine and build. */
final class MachineInfo {
    private static final String UNKNOWN = "unknown";
    private static final String DIRTY_SUFFIX = "-dirty";
    private static final long TIMEOUT_MS = 5000;
    /** Sources of the program, and the scenes of the benchmark. */
    private static final List<String> SOURCES = List.of("src/main", "pom.xml", "scenes", "textures");
    /** Command for the last commit that changed the program; commits of documents or results do not count. */
    private static final List<String> COMMIT_COMMAND = git("log", "-1", "--format=%H");
    private static final List<String> STATUS_COMMAND = git("status", "--porcelain");
    private static final Path CPU_INFO = Path.of("/proc/cpuinfo");
    private static final Pattern MODEL = Pattern.compile("(?m)^model name\\s*:\\s*(.+)$");

    private MachineInfo() {}

    static MachineSpec machine() {
        long memory = ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
                ? system.getTotalMemorySize() : 0;
        return new MachineSpec(System.getProperty("os.name") + ", " + System.getProperty("os.arch"), processor(),
                Runtime.getRuntime().availableProcessors(), FloatVector.SPECIES_PREFERRED.vectorBitSize(), memory,
                Runtime.getRuntime().maxMemory(), System.getProperty("java.vm.name") + " " + Runtime.version());
    }

    private static String processor() {
        try {
            return MODEL.matcher(Files.readString(CPU_INFO)).results().map(m -> m.group(1).strip()).findFirst().orElse(UNKNOWN);
        } catch (IOException e) {
            return UNKNOWN;
        }
    }

    /**
     * Returns the commit of the build, 40 digits, with {@code -dirty} for uncommitted changes of its sources. Returns {@code unknown} if
     * the program is not in its own repository.
     */
    static String commit() {
        try {
            URL program = MachineInfo.class.getProtectionDomain().getCodeSource().getLocation();
            // Java may not know the location of classes from a CDS archive.
            return program == null ? UNKNOWN : commit(Path.of(program.toURI()));
        } catch (URISyntaxException e) {
            return UNKNOWN;
        }
    }

    /** @param program jar or class folder of the program */
    static String commit(Path program) {
        Optional<Path> repository = repository(program);
        if (repository.isEmpty()) {
            return UNKNOWN;
        }
        Optional<String> commit = output(repository.get(), COMMIT_COMMAND, TIMEOUT_MS).filter(hash -> !hash.isEmpty());
        Optional<String> changes = output(repository.get(), STATUS_COMMAND, TIMEOUT_MS);
        return commit.isEmpty() || changes.isEmpty() ? UNKNOWN : commit.get() + (changes.get().isEmpty() ? "" : DIRTY_SUFFIX);
    }

    private static List<String> git(String... words) {
        return Stream.of(Stream.of("git"), Stream.of(words), Stream.of("--"), SOURCES.stream()).flatMap(s -> s).toList();
    }

    /**
     * Returns the nearest parent folder with this program's Maven project and a Git folder. Other repositories do not identify the build.
     */
    private static Optional<Path> repository(Path program) {
        for (Path folder = ParentFolder.of(program); folder != null; folder = folder.getParent()) {
            if (Files.exists(folder.resolve(".git"))) {
                return Files.isRegularFile(folder.resolve("src/main/java/lightning/Main.java")) ? Optional.of(folder) : Optional.empty();
            }
        }
        return Optional.empty();
    }

    /**
     * Runs a command in a repository and returns its output; empty if it fails or exceeds the time limit, in which case it is killed.
     *
     * @param timeoutMs time limit, milliseconds
     */
    static Optional<String> output(Path repository, List<String> program, long timeoutMs) {
        try {
            // A file, not a pipe: reading a pipe would block until the process ends.
            Path outputFile = Files.createTempFile("lightning", ".commit");
            try {
                return output(repository, program, timeoutMs, outputFile);
            } finally {
                Files.deleteIfExists(outputFile);
            }
        } catch (IOException e) {
            return Optional.empty();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        }
    }

    private static Optional<String> output(Path repository, List<String> program, long timeoutMs, Path outputFile)
            throws IOException, InterruptedException {
        Process git = new ProcessBuilder(program).directory(repository.toFile())
                .redirectOutput(outputFile.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        try {
            boolean hasEnded = git.waitFor(timeoutMs, TimeUnit.MILLISECONDS);
            return hasEnded && git.exitValue() == 0 ? Optional.of(Files.readString(outputFile).strip()) : Optional.empty();
        } finally {
            git.destroyForcibly();
        }
    }
}
