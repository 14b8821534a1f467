package lightning.base.process;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import lightning.base.file.RegularFile;
import lightning.base.file.ScratchFolder;
import lightning.base.file.SearchPath;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import tools.jackson.databind.json.JsonMapper;

/**
 * Converter in Python. It writes into a folder that is removed at the end, whatever happens: a result, or {@code error.txt} with one sentence.
 * Its process waits half a minute for the next file, so that Python need not start again; {@code converter.py} describes its requests.
 *
 * @param python  interpreter
 * @param script  folder of the reader, next to {@code converter.py}
 * @param limit   time after which it is ended
 * @param library package that it needs
 */
public record PythonConverter(Path python, Path script, Duration limit, PythonPackage library) {
    private static final Path SOURCES = Path.of("src", "main", "python");
    private static final int MAX_ERROR_BYTES = 1 << 24;
    /** A process that waited longer may be about to end. */
    private static final long MAX_IDLE_NANOS = 20_000_000_000L;
    private static final String ANSWER = "ended with code ";
    private static final String SUCCESS = ANSWER + "0 ";
    private static final String NO_PACKAGE = ANSWER + "3 ";
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final Map<List<String>, Idle> IDLE = new ConcurrentHashMap<>();

    /** Process that waits for a file since a time of {@link System#nanoTime}. */
    private record Idle(Process process, long since) {}

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
                script, limit, library);
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
            List<String> request = new ArrayList<>(List.of(source, folder.toString()));
            request.addAll(options);
            String problem = run(request, folder, result, progress);
            if (!problem.isEmpty()) {
                throw failure.apply(problem);
            }
            return use.read(folder);
        }
    }

    /** Sends a request to an idle process, or a new one; returns why it failed, or an empty text. */
    private String run(List<String> request, Path folder, String result, Progress progress) throws IOException {
        List<String> command = List.of(python.toString(), "-B", script.resolveSibling("converter.py").toString(), script.toString(),
                library.name());
        Idle idle = IDLE.remove(command);
        Process process = idle != null && idle.process().isAlive() && System.nanoTime() - idle.since() < MAX_IDLE_NANOS ? idle.process()
                : start(command);
        String answer;
        try {
            answer = ConverterProcess.await(process, CompletableFuture.supplyAsync(() -> ask(process, request), Thread::startVirtualThread),
                    limit, limit, progress);
        } catch (TimeoutException e) {
            return library.name() + " did not read it within " + limit.toSeconds() + " s";
        }
        IDLE.put(command, new Idle(process, System.nanoTime()));
        if (answer.startsWith(NO_PACKAGE)) {
            throw new IOException(
                    Messages.tr("{0} need the Python package {1}; run: {2} -m pip install {1}", library.title(), library.name(), python));
        }
        Path error = folder.resolve("error.txt");
        if (Files.exists(error)) {
            return firstLine(error);
        }
        return answer.startsWith(SUCCESS) && Files.exists(folder.resolve(result)) ? ""
                : "the converter of " + library.needs() + " " + ConverterProcess.shortened(answer);
    }

    private Process start(List<String> command) throws IOException {
        var builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().put("PYTHONIOENCODING", "utf-8");
        try {
            return builder.start();
        } catch (IOException e) {
            throw new IOException(Messages.tr("{0}: cannot run as Python", Quote.path(python)), e);
        }
    }

    /** Sends a request; returns the answer, which the end of the process is as well. */
    private static String ask(Process process, List<String> request) {
        try {
            Writer requests = process.outputWriter(StandardCharsets.UTF_8);
            requests.write(JSON.writeValueAsString(request) + "\n");
            requests.flush();
        } catch (IOException e) {
            // It has ended. Its code says why.
        }
        try {
            String message = "without a message";
            for (String line; (line = process.inputReader(StandardCharsets.UTF_8).readLine()) != null;) {
                if (line.startsWith(ANSWER)) {
                    return line;
                }
                message = line.isBlank() ? message : line;
            }
            return ANSWER + process.waitFor() + " (" + message + ")";
        } catch (IOException | InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    private String firstLine(Path file) throws IOException {
        return new String(RegularFile.readBytes(file, "a file of the converter", MAX_ERROR_BYTES), StandardCharsets.UTF_8).lines()
                .filter(s -> !s.isBlank()).findFirst().map(ConverterProcess::shortened).orElse("cannot be read by " + library.name());
    }
}
