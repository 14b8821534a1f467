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

/** The machine and the program that run now. */
final class MachineInfo {
    private static final String UNKNOWN = "unknown";
    private static final String DIRTY_SUFFIX = "-dirty";
    private static final long TIMEOUT_MS = 5000;
    /** What the program is built from, and the scenes that it measures. */
    private static final List<String> SOURCES = List.of("src/main", "pom.xml", "scenes", "textures");
    /** The last commit that changed the program: later commits of documents or results do not make it another build. */
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
     * The commit that the program was built from, 40 digits, if the program is still in its own repository, with {@code -dirty} where its
     * sources have changes that are not committed; else {@code unknown}.
     */
    static String commit() {
        try {
            URL program = MachineInfo.class.getProtectionDomain().getCodeSource().getLocation();
            // Of classes that come out of an archive Java may know no place.
            return program == null ? UNKNOWN : commit(Path.of(program.toURI()));
        } catch (URISyntaxException e) {
            return UNKNOWN;
        }
    }

    /** @param program the program's jar or classes */
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

    /** The nearest folder around it with Maven's project of this program and Git's folder: another's says nothing of this program. */
    private static Optional<Path> repository(Path program) {
        for (Path folder = program.toAbsolutePath().getParent(); folder != null; folder = folder.getParent()) {
            if (Files.exists(folder.resolve(".git"))) {
                return Files.isRegularFile(folder.resolve("src/main/java/lightning/Main.java")) ? Optional.of(folder) : Optional.empty();
            }
        }
        return Optional.empty();
    }

    /**
     * What a program prints about a repository; empty if it fails or does not end in time, and it is ended then.
     *
     * @param timeoutMs how long it may take, milliseconds
     */
    static Optional<String> output(Path repository, List<String> program, long timeoutMs) {
        try {
            // Into a file, not a pipe: a pipe would be read until the process ends, however long that takes.
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
