package lightning.render.warmup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.Geometry;
import lightning.sample.MixedEngineChoice;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

@Slow
class WarmUpTest {
    private Scene scene;
    private Geometry geometry;

    @BeforeEach
    void coldProcess() throws Exception {
        scene = JenReader.read(Path.of("scenes", "bird.jen")).scene();
        geometry = Geometry.of(scene);
        Engines.use(_ -> Engines.SCALAR);
    }

    @AfterEach
    void restoreMixedEngines() {
        Engines.use(new MixedEngineChoice(2));
    }

    @Test
    void warmProcess_usesFastestEngine() {
        assertThat(Engines.isFastestInUse()).isFalse();
        WarmUp.run(scene, geometry, Progress.NONE);
        assertThat(Engines.isFastestInUse()).isTrue();
        assertThat(Engines.CURRENT.forTile(0)).isEqualTo(Engines.hasLanes() ? Engines.LANES : Engines.SCALAR);
    }

    @Test
    void canceledWarmUp_leavesEngineUnchanged() {
        assertThatThrownBy(() -> WarmUp.run(scene, geometry, cancelAfter(10))).isInstanceOf(CancellationException.class);
        assertThat(Engines.CURRENT.forTile(0)).isEqualTo(Engines.SCALAR);
    }

    /** Requests to stop after a number of queries. */
    private static Progress cancelAfter(int tileCount) {
        AtomicInteger asked = new AtomicInteger();
        return new Progress() {
            @Override
            public void report(int done, int total) {}

            @Override
            public boolean isCanceled() {
                return asked.incrementAndGet() > tileCount;
            }
        };
    }
}
