package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.measure.Verification;
import lightning.render.relight.Renderer;
import org.junit.jupiter.api.Test;

/** Events between requesting and starting a verification. */
class PictureVerifierTest {
    private final RecordingRenderListener listener = new RecordingRenderListener();
    private final PictureVerifier verifier = new PictureVerifier(1, listener);

    private void verify(RenderQueue.CancelSignal request) {
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            AccuracyGuarantee promise = AccuracyGuarantee.of(renderer, renderer.render(DeskScene.scene(), Progress.NONE));
            verifier.verify(promise, renderer.film(), request);
        }
    }

    private static RenderQueue.CancelSignal cancelSignal() {
        return new RenderQueue.CancelSignal((_, _) -> {});
    }

    @Test
    void canceledRequest_isNotVerified() throws Exception {
        RenderQueue.CancelSignal asked = cancelSignal();
        asked.cancel();
        verify(asked);
        listener.expectNext(RecordingRenderListener.Event.CANCELLED);
        verifier.close();
        assertThat(listener.events).noneMatch(Verification.class::isInstance);
        assertThat(verifier.isBusy()).isFalse();
    }

    @Test
    void requestAfterClose_isDropped() {
        verifier.close();
        verify(cancelSignal());
        assertThat(verifier.isBusy()).isFalse();
        assertThat(listener.events).isEmpty();
    }
}
