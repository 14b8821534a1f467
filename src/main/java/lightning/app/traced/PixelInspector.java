package lightning.app.traced;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import lightning.scene.Scene;
import lightning.shading.PixelExplainer;

/** Tells what a pixel shows, on a thread of its own; of many questions the newest is answered. */
final class PixelInspector implements AutoCloseable {
    /** @param heard on the window's thread */
    private record Question(Scene scene, int x, int y, Consumer<PixelReport> heard) {}

    private final ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
        Thread t = new Thread(task, "lightning-inspect");
        t.setDaemon(true);
        return t;
    });
    private final AtomicReference<Question> newest = new AtomicReference<>();
    private final Executor window;
    private Scene scene;
    private PixelExplainer explainer;

    PixelInspector(Executor window) {
        this.window = window;
    }

    /**
     * Asks about a pixel of a scene.
     *
     * @param heard hears on the window's thread, unless a newer question comes before
     */
    void ask(Scene about, int x, int y, Consumer<PixelReport> heard) {
        if (newest.getAndSet(new Question(about, x, y, heard)) == null) {
            thread.execute(this::answer);
        }
    }

    private void answer() {
        Question question = newest.getAndSet(null);
        if (question == null) {
            return;
        }
        if (question.scene() != scene) {
            explainer = new PixelExplainer(question.scene());
            scene = question.scene();
        }
        PixelReport report = PixelReport.of(explainer.geometry(), explainer.pixel(question.x(), question.y()), question.x(), question.y());
        window.execute(() -> question.heard().accept(report));
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
