package lightning.base.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import lightning.base.file.RegularFile;
import lightning.base.file.ScratchFolder;
import lightning.base.file.SearchPath;
import lightning.base.file.TemporaryFolder;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;

/**
 * Converter in Python, as a process of its own. It writes into a folder that is removed at the end, whatever happens: a result, or {@code
 * error.txt} with one sentence. Its exit code is 3 if its package is not installed.
 *
 * @param python  interpreter
 * @param script  folder of the converter
 * @param limit   time after which it is ended
 * @param library package that it needs
 */
public record PythonConverter(Path python, Path script, Duration limit, PythonPackage library) {
    private static final Path SOURCES = Path.of("src", "main", "python");
    private static final int NO_PACKAGE = 3;
    private static final int MAX_MESSAGE_BYTES = 1 << 24;

    /**
     * Returns a converter of this installation.
     *
     * @param name its folder
     * @throws IOException if there is no Python, or the installation is incomplete
     */
    public static PythonConverter installed(String name, Duration limit, PythonPackage library) throws IOException {
        Path home = Path.of(System.getProperty("lightning.home", ""));
        Path shipped = home.resolve("python").resolve(name);
        Path script = Files.isDirectory(shipped) ? shipped : home.resolve(SOURCES).resolve(name);
        if (!Files.isDirectory(script)) {
            throw new IOException(Messages.tr("{0}: this converter is missing; install Lightning again", shipped));
        }
        return new PythonConverter(PythonInterpreter.find(System.getenv(PythonInterpreter.VARIABLE), SearchPath.ofSystem(), library),
                script,
                limit, library);
    }

    /** Reader of the written folder. */
    public interface Use<T, E extends Exception> {
        T read(Path folder) throws IOException, E;
    }

    /**
     * Converts a file.
     *
     * @param source  first argument; the second is the folder
     * @param options further arguments
     * @param result  name of the file that it writes if it succeeds
     * @param failure makes the exception of a sentence that says why it failed
     * @param use     reads the written files, which do not exist afterwards
     * @throws E if the package cannot read the file, or the time limit is exceeded
     * @throws IOException if the interpreter cannot run, or lacks the package
     */
    public <T, E extends Exception> T convert(String source, List<String> options, String result, Progress progress,
            Function<String, E> failure, Use<T, E> use) throws IOException, E {
        try (var scratch = ScratchFolder.createIn(Path.of(System.getProperty("java.io.tmpdir")))) {
            Path folder = Files.createDirectory(scratch.file("converted"));
            Path messages = scratch.file("messages");
            try {
                List<String> command = new ArrayList<>(List.of(python.toString(), "-B", script.toString(), source, folder.toString()));
                command.addAll(options);
                String problem = run(command, folder, messages, result, progress);
                if (!problem.isEmpty()) {
                    throw failure.apply(problem);
                }
                return use.read(folder);
            } finally {
                TemporaryFolder.delete(folder);
                Files.deleteIfExists(messages);
            }
        }
    }

    /** Runs the process; returns why it failed, or an empty text. */
    private String run(List<String> command, Path folder, Path messages, String result, Progress progress) throws IOException {
        var builder = new ProcessBuilder(command);
        builder.environment().put("PYTHONIOENCODING", "utf-8");
        int code;
        try {
            code = ConverterProcess.run(builder.redirectErrorStream(true).redirectOutput(messages.toFile()), limit, progress);
        } catch (TimeoutException e) {
            return library.name() + " did not read it within " + limit.toSeconds() + " s";
        } catch (IOException e) {
            throw new IOException(Messages.tr("{0}: cannot run as Python", Quote.path(python)), e);
        }
        if (code == NO_PACKAGE) {
            throw new IOException(
                    Messages.tr("{0} need the Python package {1}; run: {2} -m pip install {1}", library.title(), library.name(), python));
        }
        Path error = folder.resolve("error.txt");
        if (Files.exists(error)) {
            return firstLine(error);
        }
        return code == 0 && Files.exists(folder.resolve(result)) ? ""
                : "the converter of " + library.needs() + " ended with code " + code + " (" + lastLine(messages) + ")";
    }

    private static List<String> lines(Path file) throws IOException {
        return new String(RegularFile.readBytes(file, "a file of the converter", MAX_MESSAGE_BYTES), StandardCharsets.UTF_8).lines()
                .filter(s -> !s.isBlank()).toList();
    }

    private String firstLine(Path file) throws IOException {
        List<String> lines = lines(file);
        return lines.isEmpty() ? "cannot be read by " + library.name() : ConverterProcess.shortened(lines.getFirst());
    }

    private static String lastLine(Path file) throws IOException {
        List<String> lines = Files.size(file) > MAX_MESSAGE_BYTES ? List.of() : lines(file);
        return lines.isEmpty() ? "without a message" : ConverterProcess.shortened(lines.getLast());
    }
}
