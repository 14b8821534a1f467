package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the script that watches the output of the usual check. */
@DisabledOnOs(OS.WINDOWS)
class CiScriptsTest {
    private record Result(int code, String out) {}

    @Test
    void greenRun_isPrintedUnchanged() throws Exception {
        String out = "[INFO] Running lightning.ATest\n[WARNING] Tests run: 2, Failures: 0, Errors: 0, Skipped: 1\n";
        assertThat(quiet(out, 0)).isEqualTo(new Result(0, out));
    }

    @Test
    void meaninglessLines_areOmitted() throws Exception {
        assertThat(quiet("a\nWARNING: Using incubator modules: jdk.incubator.vector\n\033[33m[WARNING]\033[m ****\nb\n", 0))
                .isEqualTo(new Result(0, "a\nb\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"[WARNING] A.java:[1,2] unchecked cast", "WARNING: sun.misc.Unsafe will be removed", "java.io.EOFException",
        "\tat lightning.A.run(A.java:3)", "bash: warning: setlocale: cannot change locale", "\033[1;33m[WARNING]\033[m text"})
    void suspectLine_isPrintedAndCounted(String line) throws Exception {
        Result result = quiet("a\n" + line + "\n", 0);
        assertThat(result.code()).isZero();
        assertThat(result.out()).startsWith("a\n" + line + "\nci: 1 lines look like stack traces or warnings, the first: ");
    }

    @Test
    void exitCode_isThatOfTheCommand() throws Exception {
        assertThat(quiet("last line without an end", 3)).isEqualTo(new Result(3, "last line without an end\n"));
    }

    private static Result quiet(String output, int code) throws Exception {
        return run(Path.of(".ci/quiet"), "bash", "-c", "printf %s \"$0\"; exit \"$1\"", output, String.valueOf(code));
    }

    private static Result run(Path script, String... arguments) throws Exception {
        Process process = new ProcessBuilder(Stream.concat(Stream.of(script.toString()), Stream.of(arguments)).toList())
                .redirectErrorStream(true).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Result(process.waitFor(), out);
    }
}
