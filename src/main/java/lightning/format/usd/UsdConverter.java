package lightning.format.usd;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeoutException;
import lightning.base.file.RegularFile;
import lightning.base.file.ScratchFolder;
import lightning.base.file.SearchPath;
import lightning.base.file.TemporaryFolder;
import lightning.base.process.ConverterProcess;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.mesh.MeshException;

/**
 * The converter in Python, as a process of its own: what it writes is a folder that is removed at the end, whatever happens.
 *
 * @param python interpreter
 * @param script folder of the converter
 * @param limit  time after which it is ended
 * @param memory bytes after which it is ended
 * @param triangles number of triangles after which it is ended
 */
record UsdConverter(Path python, Path script, Duration limit, long memory, long triangles) {
    private static final String NAME = "lightning_usd";
    private static final Path SOURCES = Path.of("src", "main", "python", NAME);
    private static final Duration TIME_LIMIT = Duration.ofMinutes(10);
    /** usd-core needs a tenth of it for an empty stage. */
    private static final long MIN_MEMORY = 1L << 30;
    /** Memory that an import needs: a stage of three million triangles fails with 700 MB. */
    private static final long BYTES_PER_TRIANGLE = 300;
    private static final int NO_USD = 3;
    private static final int MAX_MESSAGE_BYTES = 1 << 24;

    /**
     * Returns the converter of this installation.
     *
     * @throws IOException if there is no Python, or the installation is incomplete
     */
    static UsdConverter installed() throws IOException {
        Path home = Path.of(System.getProperty("lightning.home", ""));
        Path shipped = home.resolve("python").resolve(NAME);
        Path script = Files.isDirectory(shipped) ? shipped : home.resolve(SOURCES);
        if (!Files.isDirectory(script)) {
            throw new IOException(Messages.tr("{0}: the converter of USD files is missing; install Lightning again", shipped));
        }
        return new UsdConverter(PythonInterpreter.find(System.getenv(PythonInterpreter.VARIABLE), SearchPath.ofSystem()), script,
                TIME_LIMIT, Math.max(MIN_MEMORY, Runtime.getRuntime().maxMemory()), Runtime.getRuntime().maxMemory() / BYTES_PER_TRIANGLE);
    }

    /** What is done with the written folder. */
    interface Use<T> {
        T read(Path folder) throws IOException, MeshException;
    }

    /**
     * Converts a stage.
     *
     * @param use reads the written files, which do not exist afterwards
     * @throws MeshException if usd-core cannot read it, or the time limit is exceeded
     * @throws IOException if the interpreter cannot run, or lacks usd-core
     */
    <T> T convert(Path source, StageChoice choice, Progress progress, Use<T> use) throws IOException, MeshException {
        try (var scratch = ScratchFolder.createIn(Path.of(System.getProperty("java.io.tmpdir")))) {
            Path folder = Files.createDirectory(scratch.file("stage"));
            try {
                run(source, choice, folder, scratch.file("messages"), progress);
                return use.read(folder);
            } finally {
                TemporaryFolder.delete(folder);
                Files.deleteIfExists(scratch.file("messages"));
            }
        }
    }

    private void run(Path source, StageChoice choice, Path folder, Path messages, Progress progress) throws IOException, MeshException {
        List<String> command = new ArrayList<>(List.of(python.toString(), "-B", script.toString(), source.toAbsolutePath().toString(),
                folder.toString(), Long.toString(memory), Long.toString(triangles)));
        command.addAll(choice.arguments());
        var builder = new ProcessBuilder(command);
        builder.environment().put("PYTHONIOENCODING", "utf-8");
        int code;
        try {
            code = ConverterProcess.run(builder.redirectErrorStream(true).redirectOutput(messages.toFile()), limit, progress);
        } catch (TimeoutException e) {
            throw new MeshException(source, "", "usd-core did not read it within " + limit.toSeconds() + " s");
        } catch (IOException e) {
            throw new IOException(Messages.tr("{0}: cannot run as Python", Quote.path(python)), e);
        }
        if (code == NO_USD) {
            throw new IOException(Messages.tr("USD files need the Python package usd-core; run: {0} -m pip install usd-core", python));
        }
        Path error = folder.resolve("error.txt");
        if (Files.exists(error)) {
            throw new MeshException(source, "", firstLine(error));
        }
        if (code != 0 || !Files.exists(folder.resolve("stage.json"))) {
            throw new MeshException(source, "", "the converter of USD files ended with code " + code + " (" + lastLine(messages) + ")");
        }
    }

    private static List<String> lines(Path file) throws IOException {
        return new String(RegularFile.readBytes(file, "a file of the converter", MAX_MESSAGE_BYTES), StandardCharsets.UTF_8).lines()
                .filter(s -> !s.isBlank()).toList();
    }

    private static String firstLine(Path file) throws IOException {
        List<String> lines = lines(file);
        return lines.isEmpty() ? "cannot be read by usd-core" : ConverterProcess.shortened(lines.getFirst());
    }

    private static String lastLine(Path file) throws IOException {
        List<String> lines = Files.size(file) > MAX_MESSAGE_BYTES ? List.of() : lines(file);
        return lines.isEmpty() ? "without a message" : ConverterProcess.shortened(lines.getLast());
    }
}
