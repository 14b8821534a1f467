package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.work.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

class ProcessIdentityTest {

    @Test
    void currentProcess_isRunning() {
        assertThat(ProcessIdentity.current().isRunning()).isTrue();
    }

    /** The shell starts a child and becomes a program that never asks for the child's exit code. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void zombie_isNotRunning() throws Exception {
        Process parent = new ProcessBuilder("sh", "-c", "exec 3<&0; sh -c 'read line' <&3 & echo $!; exec sleep 600").start();
        try (BufferedReader pids = parent.inputReader()) {
            long pid = Long.parseLong(pids.readLine());
            assertThat(new ProcessIdentity(pid, 0).isRunning()).isTrue();
            parent.outputWriter().close();
            Path state = Path.of("/proc/" + pid + "/stat");
            Await.until(() -> !Files.exists(state) || Files.readString(state).contains(") Z "));
            assumeTrue(Files.exists(state), "the system keeps no zombies");
            assertThat(new ProcessIdentity(pid, 0).isRunning()).isFalse();
        } finally {
            parent.destroyForcibly();
        }
    }
}
