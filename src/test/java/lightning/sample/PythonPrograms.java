package lightning.sample;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import lightning.base.process.PythonConverter;
import lightning.base.process.PythonPackage;
import lightning.base.work.Progress;
import org.junit.jupiter.api.Assumptions;

/**
 * Python's interpreter with other programs' packages, which the program's files are tried with. The environment variable
 * {@code LIGHTNING_PYTHON} names the interpreter, {@code python3} without it. A test whose packages are missing is skipped, but fails if
 * {@code LIGHTNING_NEEDS_PYTHON} lists one of them, such as {@code pxr,OpenEXR}.
 */
public final class PythonPrograms {
    private static final String INTERPRETER = System.getenv().getOrDefault("LIGHTNING_PYTHON", "python3");
    private static final Set<String> NEEDED = Set.of(System.getenv().getOrDefault("LIGHTNING_NEEDS_PYTHON", "").split(","));
    private static final long MAX_SECONDS = 120;
    private static final Map<String, Boolean> INSTALLED = new ConcurrentHashMap<>();

    private PythonPrograms() {}

    /** Output of a process: standard output and errors together. */
    public record Result(int exit, String text) {}

    /**
     * Skips the test unless all modules can be imported.
     *
     * @return the interpreter
     */
    public static String require(String... modules) {
        for (String module : modules) {
            boolean isThere = INSTALLED.computeIfAbsent(module, PythonPrograms::isInstalled);
            assertThat(isThere || !NEEDED.contains(module)).as("Python module " + module).isTrue();
            Assumptions.assumeTrue(isThere, "no Python module " + module);
        }
        return INTERPRETER;
    }

    private static boolean isInstalled(String module) {
        try {
            return runScript(Path.of(""), List.of("-c", "import " + module)).exit() == 0;
        } catch (IOException e) {
            return false;
        }
    }

    /**
     * Runs the interpreter.
     *
     * @param folder    working directory
     * @param arguments of the interpreter, such as a script and its arguments
     * @throws IOException if there is no interpreter, or it does not end
     */
    public static Result run(Path folder, List<String> arguments) throws IOException {
        var command = new ArrayList<>(List.of(INTERPRETER));
        command.addAll(arguments);
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        try {
            if (!process.waitFor(MAX_SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
                throw new IOException("does not end: " + command);
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            throw new IOException(e);
        }
        return new Result(process.exitValue(), text);
    }

    /**
     * Runs a script and asserts that it ends without an error. It runs in a fork of a process that has imported packages already, so it must
     * not depend on a process of its own.
     *
     * @param folder    working directory
     * @param arguments {@code -c} and a program, or a file, and its arguments
     * @return its output
     */
    public static String script(Path folder, List<String> arguments) throws IOException {
        Result result = runScript(folder, arguments);
        assertThat(result.exit()).as(result.text()).isZero();
        return result.text();
    }

    private static Result runScript(Path folder, List<String> arguments) throws IOException {
        List<String> options = new ArrayList<>(List.of("0"));
        options.addAll(arguments);
        return Scripts.CONVERTER.convert(folder.toAbsolutePath().toString(), options, "output.txt", Progress.NONE, IOException::new,
                written -> new Result(Files.exists(written.resolve("failed")) ? 1 : 0, Files.readString(written.resolve("output.txt"))));
    }

    /** Runs scripts. */
    private static final class Scripts {
        static final PythonConverter CONVERTER = converter();

        private static PythonConverter converter() {
            try {
                Path folder = Files.createDirectories(Path.of("target", "python-scripts", Long.toString(ProcessHandle.current().pid())));
                for (Path file : List.of(Path.of("src/main/python/converter.py"), Path.of("src/test/python/scripts/reader.py"))) {
                    Files.copy(file, folder.resolve(file.getFileName()), StandardCopyOption.REPLACE_EXISTING);
                }
                return new PythonConverter(Path.of(INTERPRETER), folder.toAbsolutePath().resolve("."), Duration.ofSeconds(MAX_SECONDS),
                        new PythonPackage("Python", "scripts"));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    /** Runs the interpreter and asserts that it ends without an error. Returns its output. */
    public static String output(Path folder, List<String> arguments) throws IOException {
        Result result = run(folder, arguments);
        assertThat(result.exit()).as(result.text()).isZero();
        return result.text();
    }
}
