package lightning.editor.loop;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.bench.accuracy.Promise;
import lightning.bench.accuracy.Verification;
import lightning.editor.document.Desk;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import org.junit.jupiter.api.Test;

/** What comes between the taking of a verification and its beginning. */
class VerifierTest {
    private final LoopEar ear = new LoopEar();
    private final Verifier verifier = new Verifier(1, ear);

    private void verify(RenderQueue.Stop asked) {
        try (var renderer = new Renderer(Options.DEFAULT.withThreads(1))) {
            Promise promise = Promise.of(renderer, renderer.render(Desk.scene(), Progress.NONE));
            verifier.verify(promise, renderer.film(), asked);
        }
    }

    private static RenderQueue.Stop stop() {
        return new RenderQueue.Stop((_, _) -> {});
    }

    @Test
    void cancelledOnItsWay_isNotVerified() throws Exception {
        RenderQueue.Stop asked = stop();
        asked.ask();
        verify(asked);
        ear.nextIs(LoopEar.Event.CANCELLED);
        verifier.close();
        assertThat(ear.events).noneMatch(Verification.class::isInstance);
        assertThat(verifier.isBusy()).isFalse();
    }

    @Test
    void closedOnItsWay_isForgotten() {
        verifier.close();
        verify(stop());
        assertThat(verifier.isBusy()).isFalse();
        assertThat(ear.events).isEmpty();
    }
}
