package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.work.Wait;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class HereTest {
    @TempDir
    private Path folder;

    @Test
    void repositoryOfAnotherProject_tellsNoCommit() throws Exception {
        Path jar = Files.createDirectories(folder.resolve("tools/lightning/lib")).resolve("lightning.jar");
        assertThat(git("init", "-q")).isZero();
        assertThat(git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "--allow-empty", "-m", "theirs")).isZero();
        assertThat(Here.commit(jar)).isEqualTo("unknown");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void describeThatDoesNotEnd_isEndedAndTellsNoCommit() throws Exception {
        // It holds its output open, and never ends by itself.
        Path open = Files.writeString(folder.resolve("open"), "");
        assertThat(Here.describe(folder, List.of("sh", "-c", "echo abc; exec tail -f " + open), 1000)).isEqualTo("unknown");
        Wait.until("it is ended", () -> ProcessHandle.current().descendants()
                .noneMatch(process -> process.info().commandLine().orElse("").contains(open.toString())));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void describeThatEnds_tellsWhatItSaid() {
        assertThat(Here.describe(folder, List.of("echo", "v1-2-gabc"), 20_000)).isEqualTo("v1-2-gabc");
    }

    private int git(String... arguments) throws Exception {
        var line = new java.util.ArrayList<>(java.util.List.of("git", "-C", folder.toString()));
        line.addAll(java.util.List.of(arguments));
        return new ProcessBuilder(line).start().waitFor();
    }
}
