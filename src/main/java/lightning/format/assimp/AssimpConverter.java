package lightning.format.assimp;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeoutException;
import lightning.base.file.RegularFile;
import lightning.base.file.ScratchFolder;
import lightning.base.file.TemporaryFolder;
import lightning.base.process.ConverterProcess;
import lightning.base.process.OwnProgram;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.mesh.MeshException;

/** Converter of other programs' files to glTF, by Assimp in a process of its own. */
public final class AssimpConverter {
    /** Command of this program that converts a file: the file, the new file, the memory in bytes that it may take, and whether animations are kept. */
    public static final String COMMAND = "convert-model";

    private static final Duration TIME_LIMIT = Duration.ofMinutes(10);
    /** Processor time of any file, and of a byte: a second converts 300 kB on a slow machine. */
    private static final Duration CPU_TIME = Duration.ofSeconds(10);
    private static final Duration CPU_TIME_PER_BYTE = Duration.ofNanos(30_000);
    private static final long MIN_MEMORY = 1L << 28;
    /** Bytes that a byte of a file justifies: a triangle of a compressed file takes 15 bytes there, and 3000 while it is converted. */
    private static final long MEMORY_PER_BYTE = 200;
    private static final String MESSAGES = "messages";
    private static final int MAX_MESSAGE_BYTES = 1 << 16;

    private AssimpConverter() {}

    /**
     * Reads the converted file, which does not exist afterwards.
     *
     * @param <T> what is read from it
     */
    @FunctionalInterface
    public interface Use<T> {
        /**
         * Reads the file.
         *
         * @param glb    glTF in one file; images are in it, or named as in the original file
         * @param losses number of things of each kind that it lacks
         */
        T read(Path glb, Map<String, Integer> losses) throws IOException, MeshException;
    }

    /**
     * Converts a file.
     *
     * @throws MeshException if Assimp cannot read it, or takes too long or too much memory
     * @throws IOException if it cannot be read, or this program cannot be started again
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static <T> T convert(Path source, Progress progress, Use<T> use) throws IOException, MeshException {
        RegularFile.open(source, "a file of another program").close();
        try (var scratch = ScratchFolder.createIn(Path.of(System.getProperty("java.io.tmpdir")))) {
            Path folder = Files.createDirectory(scratch.file("model"));
            Path glb = folder.resolve("converted.glb");
            try {
                Optional<String> failure = run(source, folder, glb, true, progress);
                if (failure.isPresent() && run(source, folder, glb, false, progress).isPresent()) {
                    throw problem(source, failure.get());
                }
                Map<String, Integer> losses = losses(folder.resolve(MESSAGES));
                if (failure.isPresent()) {
                    losses.put("animations, which Assimp cannot convert", 1);
                }
                return use.read(glb, losses);
            } catch (MeshException e) {
                // The user knows the source only.
                String place = Quote.path(glb) + ": ";
                String message = String.valueOf(e.getMessage());
                if (message.startsWith(place)) {
                    throw new MeshException(source, "", "converted to glTF, " + message.substring(place.length()));
                }
                throw e;
            } finally {
                TemporaryFolder.delete(folder);
            }
        }
    }

    private static MeshException problem(Path source, String reason) {
        return new MeshException(source, "", "cannot be read by Assimp: " + reason);
    }

    /** Runs the process; returns why it failed, if it may succeed without animations. */
    private static Optional<String> run(Path source, Path folder, Path glb, boolean isAnimated, Progress progress)
            throws IOException, MeshException {
        List<String> words = new ArrayList<>(OwnProgram.command());
        Duration cpuTime = CPU_TIME.plus(CPU_TIME_PER_BYTE.multipliedBy(Files.size(source)));
        long memory = MIN_MEMORY + MEMORY_PER_BYTE * Files.size(source);
        words.addAll(
                List.of(COMMAND, source.toAbsolutePath().toString(), glb.toString(), Long.toString(memory), Boolean.toString(isAnimated)));
        Path errors = folder.resolve("errors");
        // Native code that crashes leaves its files in the working folder.
        var builder = new ProcessBuilder(words).redirectOutput(folder.resolve(MESSAGES).toFile()).redirectError(errors.toFile())
                .directory(folder.toFile());
        try {
            int code = ConverterProcess.run(builder, TIME_LIMIT, cpuTime, progress);
            return switch (code) {
                case 0 -> Files.exists(glb) ? Optional.empty() : Optional.of("it wrote nothing");
                case AssimpProcess.FAILED -> Optional.of(reason(errors));
                case AssimpProcess.OUT_OF_MEMORY -> throw problem(source, "it would take more than " + (memory >> 20) + " MiB of memory");
                default -> Optional.of("it crashed");
            };
        } catch (TimeoutException e) {
            throw new MeshException(source, "", "was not converted by Assimp within " + cpuTime.toSeconds() + " s of processor time");
        }
    }

    /** Returns the sentence that the process printed. */
    private static String reason(Path errors) throws IOException {
        List<String> lines = lines(errors).stream().filter(line -> !line.startsWith("WARNING")).toList();
        String last = lines.isEmpty() ? "no reason is known" : lines.getLast();
        return ConverterProcess.shortened(last);
    }

    private static Map<String, Integer> losses(Path messages) throws IOException {
        Map<String, Integer> losses = new TreeMap<>();
        for (String line : lines(messages)) {
            String[] words = line.split("\t");
            if (words.length == 2) {
                losses.merge(words[0], Integer.parseInt(words[1]), Integer::sum);
            }
        }
        return losses;
    }

    private static List<String> lines(Path file) throws IOException {
        byte[] bytes;
        try (var in = RegularFile.open(file, "a file of the converter")) {
            bytes = in.readNBytes(MAX_MESSAGE_BYTES);
        }
        return new String(bytes, StandardCharsets.UTF_8).lines().filter(line -> !line.isBlank()).toList();
    }
}
