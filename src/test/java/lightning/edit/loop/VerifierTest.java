package lightning.edit.loop;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.accuracy.Promise;
import lightning.accuracy.Verification;
import lightning.edit.Desk;
import lightning.relight.Renderer;
import lightning.relight.tile.Options;
import lightning.work.Progress;
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
