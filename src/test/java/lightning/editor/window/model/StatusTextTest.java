package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.document.loop.RenderActivity;
import lightning.document.loop.RenderState;
import org.junit.jupiter.api.Test;

class StatusTextTest {
    private static String progress(RenderActivity.Stage stage, int done, int total, long rays) {
        return StatusText.progress(RenderState.NONE.withProgress(done, total)
                .withActivity(new RenderActivity(stage, rays, 5_000_000_000L, 4_000_000_000L)));
    }

    @Test
    void longRender_showsShareAndRate() {
        assertThat(progress(RenderActivity.Stage.CENTERS, 25, 100, 5_200_000)).isEqualTo("Refining… 25 % · 1.3 million rays/s");
    }

    @Test
    void finerSamples_haveTheirOwnWord() {
        assertThat(progress(RenderActivity.Stage.SAMPLES, 1, 2, 0)).isEqualTo("Anti-aliasing… 50 %");
    }

    @Test
    void coarseImages_haveNoShare() {
        assertThat(progress(RenderActivity.Stage.CENTERS, 0, 0, 0)).isEqualTo("Refining…");
    }
}
