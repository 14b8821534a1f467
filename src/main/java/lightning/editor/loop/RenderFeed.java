package lightning.editor.loop;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.render.image.Film;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Carries what a render loop tells from its threads to the window's. However much is told before the window has time to
 * listen, it hears once, of the newest state. A picture and whether more is to be done, which are told one right after the other, it
 * hears at once: each time it writes all panes. Of a document that was left nothing is told, whatever its loop still does.
 */
public final class RenderFeed implements RenderListener {
    /** How far a work is is told so often at most, nanoseconds: the window's thread takes a processor from the work each time. */
    private static final long STEP_NS = 40_000_000;

    private final Executor window;
    private final RenderListener canvas;
    private final Runnable heard;
    private final AtomicBoolean hopping = new AtomicBoolean();
    /** When it was last told how far a work is, or that one begins. */
    private final AtomicLong toldAt = new AtomicLong(System.nanoTime());
    /** Held while the canvas is filled, so that it is emptied after what it shows of the document before. */
    private final Object filling = new Object();
    private RenderState state = RenderState.NONE;
    /** The number of the document that is open, and of that whose forerunners the loop has dropped. */
    private long open;
    private long dropped;

    /**
     * @param window runs tasks in turn on the window's thread
     * @param canvas hears all on the loop's threads, where it holds up nobody, before the window does
     * @param heard  hears on the window's thread that the state is another
     */
    public RenderFeed(Executor window, RenderListener canvas, Runnable heard) {
        this.window = window;
        this.canvas = canvas;
        this.heard = heard;
    }

    /** What was told, up to now. */
    public synchronized RenderState state() {
        return state;
    }

    /** Another document takes the place of the one before; {@link #forgotten} with its number tells that the loop has left that. */
    public void open(long number) {
        synchronized (this) {
            open = number;
            state = RenderState.NONE;
        }
        synchronized (filling) {
            canvas.forgotten(number);
        }
    }

    /** What waited was cancelled, also where the loop has not left the document before. */
    public synchronized void cancelledUnbegun() {
        state = state.stopped(null);
    }

    private synchronized boolean isOfTheOpenDocument() {
        return dropped == open;
    }

    private void fill(Runnable step) {
        synchronized (filling) {
            if (isOfTheOpenDocument()) {
                step.run();
            }
        }
    }

    /** Returns whether it is of the open document. */
    private synchronized boolean note(UnaryOperator<RenderState> change) {
        boolean open = isOfTheOpenDocument();
        state = open ? change.apply(state) : state;
        return open;
    }

    private void tell(UnaryOperator<RenderState> change) {
        if (note(change) && hopping.compareAndSet(false, true)) {
            window.execute(() -> {
                hopping.set(false);
                heard.run();
            });
        }
    }

    /** Whether a work has gone on for long enough to tell again how far it is; its end is told in any case. */
    private boolean isTime(int done, int total) {
        long last = toldAt.get();
        long now = System.nanoTime();
        return done == total || now - last > STEP_NS && toldAt.compareAndSet(last, now);
    }

    @Override
    public void started(UpdatePlan plan) {
        toldAt.set(System.nanoTime());
        canvas.started(plan);
        tell(s -> s.started(plan));
    }

    @Override
    public void progress(int done, int total) {
        canvas.progress(done, total);
        if (done == total) {
            // Heard with what came of it.
            note(s -> s.at(done, total));
        } else if (isTime(done, total)) {
            tell(s -> s.at(done, total));
        }
    }

    @Override
    public void verifying(int done, int total) {
        canvas.verifying(done, total);
        if (isTime(done, total)) {
            tell(s -> s.checking(done, total));
        }
    }

    @Override
    public void coarse(Film film, Scene scene) {
        fill(() -> canvas.coarse(film, scene));
        tell(s -> s);
    }

    @Override
    public void tile(Scene scene, int tile, float[][] film) {
        fill(() -> canvas.tile(scene, tile, film));
    }

    @Override
    public void rendered(Frame frame) {
        fill(() -> canvas.rendered(frame));
        note(s -> s.rendered(frame));
    }

    @Override
    public synchronized void forgotten(long number) {
        dropped = number;
    }

    @Override
    public void measured(WarmSaving saving) {
        canvas.measured(saving);
        tell(s -> s.measured(saving));
    }

    @Override
    public void verified(Verification verification) {
        canvas.verified(verification);
        tell(s -> s.verified(verification));
    }

    @Override
    public void cancelled() {
        canvas.cancelled();
        tell(s -> s.stopped(null));
    }

    @Override
    public void failed(Throwable problem) {
        canvas.failed(problem);
        tell(s -> s.stopped(problem));
    }

    @Override
    public void goesOn() {
        tell(s -> s);
    }

    @Override
    public void idle() {
        fill(canvas::idle);
        tell(s -> s);
    }
}
