package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import lightning.document.DeskScene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests the order in which a queue hands out its jobs. */
class RenderQueueTest {
    private final RenderQueue queue = new RenderQueue(Duration.ZERO);

    private RenderQueue.Job take() throws InterruptedException {
        return queue.take(new RenderQueue.CancelSignal((_, _) -> {}));
    }

    /** A scene was saved, another one opened, and the window closed, before the loop came to any of them. */
    @Test
    void closedAfterOpening_firstKeepsTheSavedImage() throws InterruptedException {
        queue.requestKeeping();
        queue.open(DeskScene.scene(), 1);
        queue.close();
        assertThat(take()).isInstanceOf(RenderQueue.Job.KeepPicture.class);
        assertThat(take()).isNull();
    }

    @Test
    void closedWithoutARequest_keepsNothing() throws InterruptedException {
        queue.open(DeskScene.scene(), 1);
        queue.close();
        assertThat(take()).isNull();
    }

    @Test
    @Timeout(60)
    void samplesThatAnEditInterrupted_waitForTheEndOfADrag() throws InterruptedException {
        var patient = new RenderQueue(Duration.ofHours(1));
        patient.requestSamples();
        patient.take(new RenderQueue.CancelSignal((_, _) -> {}));
        patient.render(DeskScene.scene());
        patient.finishJob(null);
        assertThat(patient.take(new RenderQueue.CancelSignal((_, _) -> {}))).isInstanceOf(RenderQueue.Job.Render.class);
        patient.finishJob(null);
        Thread taker = Thread.currentThread();
        Thread.ofVirtual().start(() -> {
            while (taker.getState() != Thread.State.TIMED_WAITING) {
                Thread.onSpinWait();
            }
            patient.render(DeskScene.scene());
        });
        assertThat(patient.take(new RenderQueue.CancelSignal((_, _) -> {}))).isInstanceOf(RenderQueue.Job.Render.class);
    }
}
