package lightning.sample;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
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
            boolean isThere = isInstalled(module);
            assertThat(isThere || !NEEDED.contains(module)).as("Python module " + module).isTrue();
            Assumptions.assumeTrue(isThere, "no Python module " + module);
        }
        return INTERPRETER;
    }

    private static boolean isInstalled(String module) {
        try {
            return run(Path.of("."), List.of("-c", "import " + module)).exit() == 0;
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

    /** Runs the interpreter and asserts that it ends without an error. Returns its output. */
    public static String output(Path folder, List<String> arguments) throws IOException {
        Result result = run(folder, arguments);
        assertThat(result.exit()).as(result.text()).isZero();
        return result.text();
    }
}
