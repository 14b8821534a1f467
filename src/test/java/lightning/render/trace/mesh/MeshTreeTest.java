package lightning.render.trace.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import lightning.base.work.Await;
import lightning.sample.SampleMeshes;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests BVHs of meshes that are requested by many threads. */
@Slow
class MeshTreeTest {
    /** Enough for several threads to build a BVH. */
    private static final int TRIANGLES = 30_000;
    private static final int TREES = 60;

    @Test
    // Threads in a deadlock never finish.
    @Timeout(value = 5 * Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void commonPoolThreads_canRequestTreesConcurrently() {
        long built = IntStream.range(0, TREES).parallel().mapToObj(seed -> MeshTree.of(SampleMeshes.randomTriangles(TRIANGLES, seed)))
                .filter(tree -> tree.bytes() > 0).count();
        assertThat(built).isEqualTo(TREES);
    }
}
