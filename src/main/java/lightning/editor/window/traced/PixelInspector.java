package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.document.loop.Frame;
import lightning.render.shading.explanation.PixelExplainer;
import org.jspecify.annotations.Nullable;

/** Inspects pixels on a separate thread. Only the newest request is answered. */
final class PixelInspector implements AutoCloseable {
    /**
     * Pending request.
     *
     * @param listener called on the window's thread
     */
    private record Request(Frame frame, int x, int y, Consumer<PixelReport> listener) {}

    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-inspect");
    private final AtomicReference<Request> pending = new AtomicReference<>();
    private final Executor windowExecutor;
    private @Nullable Frame lastFrame;
    private @Nullable PixelExplainer explainer;

    PixelInspector(Executor windowExecutor) {
        this.windowExecutor = windowExecutor;
    }

    /**
     * Requests a report on a pixel of a picture.
     *
     * @param listener receives the report on the window's thread, unless a newer request replaces this one
     */
    void request(Frame frame, int x, int y, Consumer<PixelReport> listener) {
        if (pending.getAndSet(new Request(frame, x, y, listener)) == null) {
            thread.execute(this::processRequest);
        }
    }

    private void processRequest() {
        Request request = pending.getAndSet(null);
        if (request == null) {
            return;
        }
        if (request.frame() != lastFrame) {
            lastFrame = request.frame();
            explainer = explainer == null ? new PixelExplainer(lastFrame.scene(), lastFrame.geometry())
                    : explainer.forScene(lastFrame.scene(), lastFrame.geometry());
            explainer = explainer.withIndirect(lastFrame.indirect());
        }
        PixelReport report =
                PixelReport.of(requireNonNull(explainer).geometry(), requireNonNull(explainer).explainPixel(request.x(), request.y()),
                        lastFrame.scene().lights().size(), request.x(), request.y());
        windowExecutor.execute(() -> request.listener().accept(report));
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}
