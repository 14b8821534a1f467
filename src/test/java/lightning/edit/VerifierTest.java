package lightning.edit;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.image.Film;
import lightning.relight.Options;
import lightning.relight.Renderer;
import lightning.scene.Scene;
import lightning.shading.Progress;
import org.junit.jupiter.api.Test;

/** What comes between the taking of a verification and its beginning. */
class VerifierTest {
    private final LoopEar ear = new LoopEar();
    private final Verifier verifier = new Verifier(1, ear);

    private static Verification.Request request() {
        Scene scene = Desk.scene();
        try (var renderer = new Renderer(Options.DEFAULT.withThreads(1))) {
            renderer.render(scene, Progress.NONE);
            Film film = renderer.film();
            return new Verification.Request(film, scene, scene, renderer.cache().geometry());
        }
    }

    private static RenderQueue.Stop stop() {
        return new RenderQueue.Stop((_, _) -> {});
    }

    @Test
    void cancelledOnItsWay_isNotVerified() throws Exception {
        RenderQueue.Stop asked = stop();
        asked.ask();
        verifier.verify(request(), asked);
        ear.nextIs(LoopEar.Event.CANCELLED);
        verifier.close();
        assertThat(ear.events).noneMatch(Verification.class::isInstance);
        assertThat(verifier.isBusy()).isFalse();
    }

    @Test
    void closedOnItsWay_isForgotten() {
        verifier.close();
        verifier.verify(request(), stop());
        assertThat(verifier.isBusy()).isFalse();
        assertThat(ear.events).isEmpty();
    }
}
