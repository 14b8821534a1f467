package lightning.render.warmup;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.render.engine.choice.Engines;
import lightning.sample.MixedEngineChoice;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class DelayedLanesTest {
    @BeforeEach
    void coldProcess() {
        Engines.use(_ -> Engines.SCALAR);
    }

    @AfterEach
    void restoreMixedEngines() {
        Engines.use(new MixedEngineChoice(2));
    }

    @Test
    void shortWork_keepsItsEngine() {
        new DelayedLanes().close();
        assertThat(Engines.isFastestInUse()).isFalse();
    }

    @Test
    @Timeout(60)
    void longWork_switchesToTheFastestEngine() {
        try (var _ = new DelayedLanes(1)) {
            while (!Engines.isFastestInUse()) {
                Thread.onSpinWait();
            }
        }
        assertThat(Engines.isFastestInUse()).isTrue();
    }
}
