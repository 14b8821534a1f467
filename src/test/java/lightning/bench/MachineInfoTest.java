package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class MachineInfoTest {
    @TempDir
    private Path folder;

    @Test
    void foreignRepository_givesUnknownCommit() throws Exception {
        Path jar = Files.createDirectories(folder.resolve("tools/lightning/lib")).resolve("lightning.jar");
        assertThat(git("init", "-q")).isZero();
        assertThat(git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "--allow-empty", "-m", "theirs")).isZero();
        assertThat(MachineInfo.commit(jar)).isEqualTo("unknown");
    }

    @Test
    void commit_isLastProgramCommitAndDirtyOnlyBySources() throws Exception {
        Path sources = Files.createDirectories(folder.resolve("src/main/java/lightning"));
        Path main = Files.writeString(sources.resolve("Main.java"), "one");
        Path classes = Files.createDirectories(folder.resolve("target/classes"));
        Path docs = Files.createDirectories(folder.resolve("docs"));
        git("init", "-q");
        commitAll("program");
        String built = head();
        assertThat(built).hasSize(40);
        assertThat(MachineInfo.commit(classes)).isEqualTo(built);

        Files.writeString(docs.resolve("results.md"), "what was measured");
        assertThat(MachineInfo.commit(classes)).as("uncommitted document").isEqualTo(built);
        commitAll("documents");
        assertThat(head()).isNotEqualTo(built);
        assertThat(MachineInfo.commit(classes)).as("later commit of documents").isEqualTo(built);

        Files.writeString(main, "two");
        assertThat(MachineInfo.commit(classes)).as("changed source").isEqualTo(built + "-dirty");
        commitAll("changed");
        assertThat(MachineInfo.commit(classes)).isEqualTo(head());
        Files.writeString(sources.resolve("New.java"), "new");
        assertThat(MachineInfo.commit(classes)).as("new source").isEqualTo(head() + "-dirty");
    }

    private void commitAll(String message) throws Exception {
        git("add", "src", "docs");
        assertThat(git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", message)).isZero();
    }

    private String head() throws Exception {
        Process process = new ProcessBuilder("git", "-C", folder.toString(), "rev-parse", "HEAD").start();
        return new String(process.getInputStream().readAllBytes(), java.nio.charset.StandardCharsets.UTF_8).strip();
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void commandTimeout_endsProcessAndGivesNoOutput() throws Exception {
        // Keeps its output open and never ends.
        Path open = Files.writeString(folder.resolve("open"), "");
        assertThat(MachineInfo.output(folder, List.of("sh", "-c", "echo abc; exec tail -f " + open), 1000)).isEmpty();
        Await.until("it is ended", () -> ProcessHandle.current().descendants()
                .noneMatch(process -> process.info().commandLine().orElse("").contains(open.toString())));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void command_returnsItsOutput() {
        assertThat(MachineInfo.output(folder, List.of("echo", "v1-2-gabc"), 20_000)).contains("v1-2-gabc");
    }

    private int git(String... arguments) throws Exception {
        var line = new java.util.ArrayList<>(java.util.List.of("git", "-C", folder.toString()));
        line.addAll(java.util.List.of(arguments));
        return new ProcessBuilder(line).start().waitFor();
    }
}
