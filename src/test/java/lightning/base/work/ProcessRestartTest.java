package lightning.base.work;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
class ProcessRestartTest {

    /** Replaces itself by the program that its arguments name. */
    static final class RestartingProgram {
        public static void main(String[] args) {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> System.out.println("its hook")));
            ProcessRestart.exec(List.of(args));
            System.out.println("continues");
        }
    }

    @Test
    void restart_keepsPidStreamsAndExitCode() throws Exception {
        Process process = startRestarting("/bin/sh", "-c", "echo $$ \"$1\"; cat; exit 7", "sh", "a b");
        try (var in = process.getOutputStream()) {
            in.write("to be read\n".getBytes(StandardCharsets.UTF_8));
        }
        assertThat(output(process)).isEqualTo(process.pid() + " a b\nto be read\n");
        assertThat(process.waitFor()).isEqualTo(7);
    }

    @Test
    void missingProgram_continues() throws Exception {
        Process process = startRestarting("/no/such/program");
        assertThat(output(process)).isEqualTo("continues\nits hook\n");
        assertThat(process.waitFor()).isZero();
    }

    private static Process startRestarting(String... words) throws IOException {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin/java").toString(),
                "--enable-native-access=ALL-UNNAMED", "-cp", System.getProperty("java.class.path"), RestartingProgram.class.getName()));
        line.addAll(List.of(words));
        return new ProcessBuilder(line).start();
    }

    private static String output(Process process) throws IOException {
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
