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
import lightning.sample.EngineMix;
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
        geometry = new Geometry(scene);
        Engines.use(_ -> Engines.SCALAR);
    }

    @AfterEach
    void mixedAgain() {
        Engines.use(new EngineMix(2));
    }

    @Test
    void process_usesWhatIsFastestOnceThatIsWarm() {
        assertThat(Engines.areFastest()).isFalse();
        WarmUp.run(scene, geometry, Progress.NONE);
        assertThat(Engines.areFastest()).isTrue();
        assertThat(Engines.OF_PROCESS.forTile(0)).isEqualTo(Engines.hasLanes() ? Engines.LANES : Engines.SCALAR);
    }

    @Test
    void stoppedOnItsWay_leavesTheProcessAsItWas() {
        assertThatThrownBy(() -> WarmUp.run(scene, geometry, stopping(10))).isInstanceOf(CancellationException.class);
        assertThat(Engines.OF_PROCESS.forTile(0)).isEqualTo(Engines.SCALAR);
    }

    @Test
    void shortWork_warmsNothingUp() {
        new LateWarmUp(scene).close();
        assertThat(Engines.areFastest()).isFalse();
    }

    /** Stops when it was asked a number of times. */
    private static Progress stopping(int after) {
        AtomicInteger asked = new AtomicInteger();
        return new Progress() {
            @Override
            public void tiles(int done, int total) {}

            @Override
            public boolean isCancelled() {
                return asked.incrementAndGet() > after;
            }
        };
    }
}
