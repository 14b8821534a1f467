package lightning.editor.loop;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.editor.document.DeskScene;
import org.junit.jupiter.api.Test;

/** Tests the order in which a queue hands out its jobs. */
class RenderQueueTest {
    private final RenderQueue queue = new RenderQueue();

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
}
