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
import jdk.incubator.vector.FloatVector;

/** The machine and the program that run now. */
final class Here {
    private static final String UNKNOWN = "unknown";
    private static final long PATIENCE_MS = 5000;
    private static final List<String> GIT = List.of("git", "describe", "--always", "--dirty");

    private Here() {}

    static Machine machine() {
        long memory = ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
                ? system.getTotalMemorySize() : 0;
        return new Machine(System.getProperty("os.name") + ", " + System.getProperty("os.arch"),
                Runtime.getRuntime().availableProcessors(), FloatVector.SPECIES_PREFERRED.vectorBitSize(), memory,
                Runtime.getRuntime().maxMemory(), System.getProperty("java.vm.name") + " " + Runtime.version());
    }

    /** The commit that the program was built from, if it still lies in its own repository; else {@code unknown}. */
    static String commit() {
        try {
            URL program = Here.class.getProtectionDomain().getCodeSource().getLocation();
            // Of classes that come out of an archive Java may know no place.
            return program == null ? UNKNOWN : commit(Path.of(program.toURI()));
        } catch (URISyntaxException e) {
            return UNKNOWN;
        }
    }

    /** @param program the program's jar or classes */
    static String commit(Path program) {
        Optional<Path> repository = repository(program);
        return repository.isEmpty() ? UNKNOWN : describe(repository.get(), GIT, PATIENCE_MS);
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
     * What a program says of a repository; {@code unknown} if it fails or does not end in time, and it is ended then.
     *
     * @param patienceMs how long it may take, milliseconds
     */
    static String describe(Path repository, List<String> program, long patienceMs) {
        try {
            // Into a file, not a pipe: a pipe would be read until the process ends, however long that takes.
            Path said = Files.createTempFile("lightning", ".commit");
            try {
                return describe(repository, program, patienceMs, said);
            } finally {
                Files.deleteIfExists(said);
            }
        } catch (IOException e) {
            return UNKNOWN;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return UNKNOWN;
        }
    }

    private static String describe(Path repository, List<String> program, long patienceMs, Path said)
            throws IOException, InterruptedException {
        Process git = new ProcessBuilder(program).directory(repository.toFile())
                .redirectOutput(said.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        try {
            boolean ended = git.waitFor(patienceMs, TimeUnit.MILLISECONDS);
            String commit = ended && git.exitValue() == 0 ? Files.readString(said).strip() : "";
            return commit.isEmpty() ? UNKNOWN : commit;
        } finally {
            git.destroyForcibly();
        }
    }
}
