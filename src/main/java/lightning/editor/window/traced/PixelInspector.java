package lightning.editor.window.traced;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import lightning.base.work.OwnThread;
import lightning.editor.loop.Frame;
import lightning.render.shading.PixelExplainer;

/** Tells what a pixel shows, on a thread of its own; of many questions the newest is answered. */
final class PixelInspector implements AutoCloseable {
    /** @param heard on the window's thread */
    private record Question(Frame about, int x, int y, Consumer<PixelReport> heard) {}

    private final ExecutorService thread = OwnThread.inTurn("lightning-inspect");
    private final AtomicReference<Question> newest = new AtomicReference<>();
    private final Executor window;
    private Frame about;
    private PixelExplainer explainer;

    PixelInspector(Executor window) {
        this.window = window;
    }

    /**
     * Asks about a pixel of a picture.
     *
     * @param heard hears on the window's thread, unless a newer question comes before
     */
    void ask(Frame about, int x, int y, Consumer<PixelReport> heard) {
        if (newest.getAndSet(new Question(about, x, y, heard)) == null) {
            thread.execute(this::answer);
        }
    }

    private void answer() {
        Question question = newest.getAndSet(null);
        if (question == null) {
            return;
        }
        if (question.about() != about) {
            about = question.about();
            explainer = explainer == null ? new PixelExplainer(about.scene(), about.geometry())
                    : explainer.forScene(about.scene(), about.geometry());
        }
        PixelReport report = PixelReport.of(explainer.geometry(), explainer.pixel(question.x(), question.y()),
                about.scene().lights().size(), question.x(), question.y());
        window.execute(() -> question.heard().accept(report));
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
