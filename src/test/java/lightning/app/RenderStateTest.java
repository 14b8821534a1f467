package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.relight.UpdatePlan;
import org.junit.jupiter.api.Test;

class RenderStateTest {
    private static final RenderState MEASURED = RenderState.NONE.measured(30);

    private static UpdatePlan relight(boolean resampled) {
        return new UpdatePlan.Relight(null, null, 2, 2, resampled);
    }

    @Test
    void edit_keepsTheTimeOfAFullTrace() {
        assertThat(MEASURED.started(relight(false)).fullTraceMs()).isEqualTo(30);
    }

    @Test
    void otherSamples_makeTheTimeOfAFullTraceUnknown() {
        assertThat(MEASURED.started(relight(true)).fullTraceMs()).isNaN();
    }
}
