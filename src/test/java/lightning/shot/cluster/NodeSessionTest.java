package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThatCode;

import java.nio.file.Path;
import java.util.UUID;
import lightning.base.work.Await;
import lightning.render.RenderOptions;
import lightning.shot.LocalFrameHost;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NodeSessionTest {
    @TempDir
    private Path folder;

    /** A node that ends closes its sessions while it may learn that their coordinator is gone. */
    @Test
    void secondClose_hasNoEffect() throws Exception {
        var host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 1 << 20);
        var session = new NodeSession(new ClusterMember(new UUID(1, 2)), new UUID(3, 4), host, new ContentFolder(folder), _ -> {});
        session.close();
        assertThatCode(session::close).doesNotThrowAnyException();
        Await.untilThreadEnded("lightning-node");
    }
}
