package lightning.work;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

@EnabledOnOs(OS.LINUX)
class SuccessorTest {

    /** Gives its place to a shell with a word of a letter beyond ASCII. */
    static final class Predecessor {
        public static void main(String[] args) {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> System.out.println("hook")));
            Successor.take(List.of("/bin/sh", "-c", "echo $$ \"$1\"; cat; exit 7", "sh", "ä b"));
            System.out.println("returned");
        }
    }

    @Test
    void successor_hasNumberStreamsAndExitCode() throws Exception {
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin/java").toString(),
                "--enable-native-access=ALL-UNNAMED", "-Dsun.jnu.encoding=UTF-8", "-cp", System.getProperty("java.class.path"),
                Predecessor.class.getName()).start();
        try (var in = process.getOutputStream()) {
            in.write("to be read\n".getBytes(StandardCharsets.UTF_8));
        }
        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEqualTo(process.pid() + " ä b\nto be read\n");
        assertThat(process.waitFor()).isEqualTo(7);
    }

    @Test
    void programThatIsNotThere_leavesThisOne() {
        Successor.take(List.of("/no/such/program"));
        assertThat(ProcessHandle.current().isAlive()).isTrue();
    }
}
