package lightning.app.model;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import lightning.accuracy.Verification;
import lightning.accuracy.WarmSaving;
import lightning.edit.loop.Frame;
import lightning.edit.loop.RenderListener;
import lightning.image.Film;
import lightning.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Carries what the render loop tells from its threads to the window's. However much is told before the window has
 * time to listen, it hears once, of the newest state.
 */
final class RenderFeed implements RenderListener {
    private final AtomicReference<RenderState> state = new AtomicReference<>(RenderState.NONE);
    private final AtomicBoolean hopping = new AtomicBoolean();
    private final Executor window;
    private final TracedRaster raster;
    private final Consumer<RenderState> listener;

    /**
     * @param window   runs tasks in turn on the window's thread
     * @param raster   is filled here, where it holds up nobody
     * @param listener hears on the window's thread
     */
    RenderFeed(Executor window, TracedRaster raster, Consumer<RenderState> listener) {
        this.window = window;
        this.raster = raster;
        this.listener = listener;
    }

    private void tell(UnaryOperator<RenderState> change) {
        state.updateAndGet(change);
        if (hopping.compareAndSet(false, true)) {
            window.execute(() -> {
                hopping.set(false);
                listener.accept(state.get());
            });
        }
    }

    @Override
    public void started(UpdatePlan plan) {
        tell(s -> s.started(plan));
    }

    @Override
    public void progress(int done, int total) {
        tell(s -> s.at(done, total));
    }

    @Override
    public void verifying(int done, int total) {
        tell(s -> s.checking(done, total));
    }

    @Override
    public void coarse(Film film, Scene scene) {
        raster.coarse(film, scene.picture().width(), scene.picture().height());
        tell(s -> s);
    }

    @Override
    public void rendered(Frame frame) {
        raster.show(frame.seen());
        tell(s -> s.rendered(frame));
    }

    /** Nothing of the next document is rendered yet, and nothing of the last is shown under its name. */
    @Override
    public void forgotten() {
        raster.clear();
        tell(_ -> RenderState.NONE);
    }

    @Override
    public void measured(WarmSaving saving) {
        tell(s -> s.measured(saving));
    }

    @Override
    public void verified(Verification verification) {
        tell(s -> s.verified(verification));
    }

    @Override
    public void cancelled() {
        tell(s -> s.stopped(null));
    }

    @Override
    public void failed(Throwable problem) {
        tell(s -> s.stopped(problem));
    }

    @Override
    public void idle() {
        tell(s -> s);
    }
}
