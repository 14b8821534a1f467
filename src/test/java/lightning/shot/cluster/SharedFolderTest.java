package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.base.work.Await;
import lightning.sample.Nightly;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Node processes with a common folder, like machines with a shared home folder. {@link RenderNodeTest} uses folders of nodes in the usual
 * check.
 */
@Nightly
final class SharedFolderTest {
    private static final String REFUSED = "another node uses this folder; choose another one with --folder";

    @TempDir
    private Path folder;

    @Test
    void secondNodeInFolder_isRejected_folderOfKilledNodeIsFree() throws Exception {
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        int port = FreePort.next();
        Path log = folder.resolve("node-" + port + ".log");
        var first = new NodeProcess(port, List.of(), folder);
        try (first) {
            Await.until("the node takes part", () -> Files.readString(log).contains("node running at"));
            assertThat(folder.resolve("lightning-node-127.0.0.1-" + port)).isDirectory();
            try (var second = new NodeProcess(port, List.of(), folder)) {
                assertThat(second.exit()).isEqualTo(2);
            }
            assertThat(Files.readString(log)).contains("lightning-node-127.0.0.1-" + port + ": " + REFUSED).doesNotContain("Exception");
        }
        Files.delete(log);
        try (var _ = new NodeProcess(port, List.of(), folder)) {
            Await.until("the node takes part", () -> Files.readString(log).contains("node running at"));
        }
    }
}
