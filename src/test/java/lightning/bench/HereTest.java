package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
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

    private int git(String... arguments) throws Exception {
        var line = new java.util.ArrayList<>(java.util.List.of("git", "-C", folder.toString()));
        line.addAll(java.util.List.of(arguments));
        return new ProcessBuilder(line).start().waitFor();
    }
}
