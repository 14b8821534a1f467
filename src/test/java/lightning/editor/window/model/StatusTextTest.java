package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.loop.RenderActivity;
import lightning.editor.loop.RenderState;
import org.junit.jupiter.api.Test;

class StatusTextTest {
    private static final long SECOND = 1_000_000_000;

    private final RemainingTime remaining = new RemainingTime();

    private String progress(RenderActivity.Stage stage, int done, int total, long rays, long seconds) {
        return StatusText.progress(RenderState.NONE.withProgress(done, total)
                .withActivity(new RenderActivity(stage, rays, seconds * SECOND, seconds * SECOND)), remaining, seconds * SECOND);
    }

    @Test
    void longRender_showsShareTimeLeftAndRate() {
        progress(RenderActivity.Stage.CENTERS, 0, 100, 0, 0);
        assertThat(progress(RenderActivity.Stage.CENTERS, 25, 100, 5_200_000, 4))
                .isEqualTo("Refining… 25 % · 15 s left · 1.3 million rays/s");
    }

    @Test
    void finerSamples_haveTheirOwnWordAndTime() {
        progress(RenderActivity.Stage.CENTERS, 0, 100, 0, 0);
        progress(RenderActivity.Stage.SAMPLES, 0, 100, 0, 100);
        assertThat(progress(RenderActivity.Stage.SAMPLES, 50, 100, 0, 102)).isEqualTo("Anti-aliasing… 50 % · 2 s left");
    }

    @Test
    void coarseImages_haveNoShare() {
        assertThat(progress(RenderActivity.Stage.CENTERS, 0, 0, 0, 0)).isEqualTo("Refining…");
    }
}
