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
    private static final long REPORT_INTERVAL_NS = 40_000_000;

    private final Executor window;
    private final RenderListener canvas;
    private final Runnable stateListener;
    private final AtomicBoolean notificationPending = new AtomicBoolean();
    /** When it was last told how far a work is, or that one begins. */
    private final AtomicLong lastReportNs = new AtomicLong(System.nanoTime());
    /** Held while the canvas is filled, so that it is emptied after what it shows of the document before. */
    private final Object canvasLock = new Object();
    private RenderState state = RenderState.NONE;
    /** The number of the document that is open, and of that whose forerunners the loop has dropped. */
    private long openDocument;
    private long currentDocument;

    /**
     * @param window runs tasks in turn on the window's thread
     * @param canvas hears all on the loop's threads, where it holds up nobody, before the window does
     * @param stateListener  hears on the window's thread that the state is another
     */
    public RenderFeed(Executor window, RenderListener canvas, Runnable stateListener) {
        this.window = window;
        this.canvas = canvas;
        this.stateListener = stateListener;
    }

    /** What was told, up to now. */
    public synchronized RenderState state() {
        return state;
    }

    /** Another document takes the place of the one before; {@link #pictureDropped} with its number tells that the loop has left that. */
    public void open(long number) {
        synchronized (this) {
            openDocument = number;
            state = RenderState.NONE;
        }
        synchronized (canvasLock) {
            canvas.pictureDropped(number);
        }
    }

    /** What waited was canceled, also where the loop has not left the document before. */
    public synchronized void waitingRenderCanceled() {
        state = state.withStop(null);
    }

    private synchronized boolean isOpenDocumentCurrent() {
        return currentDocument == openDocument;
    }

    private void updateCanvas(Runnable step) {
        synchronized (canvasLock) {
            if (isOpenDocumentCurrent()) {
                step.run();
            }
        }
    }

    /** Returns whether it is of the open document. */
    private synchronized boolean changeState(UnaryOperator<RenderState> change) {
        boolean isCurrent = isOpenDocumentCurrent();
        state = isCurrent ? change.apply(state) : state;
        return isCurrent;
    }

    private void publish(UnaryOperator<RenderState> change) {
        if (changeState(change) && notificationPending.compareAndSet(false, true)) {
            window.execute(() -> {
                notificationPending.set(false);
                stateListener.run();
            });
        }
    }

    /** Whether a work has gone on for long enough to tell again how far it is; its end is told in any case. */
    private boolean isReportDue(int done, int total) {
        long last = lastReportNs.get();
        long now = System.nanoTime();
        return done == total || now - last > REPORT_INTERVAL_NS && lastReportNs.compareAndSet(last, now);
    }

    @Override
    public void started(UpdatePlan plan) {
        lastReportNs.set(System.nanoTime());
        canvas.started(plan);
        publish(s -> s.withPlan(plan));
    }

    @Override
    public void progress(int done, int total) {
        canvas.progress(done, total);
        if (done == total) {
            // Heard with what came of it.
            changeState(s -> s.withProgress(done, total));
        } else if (isReportDue(done, total)) {
            publish(s -> s.withProgress(done, total));
        }
    }

    @Override
    public void verificationProgress(int done, int total) {
        canvas.verificationProgress(done, total);
        if (isReportDue(done, total)) {
            publish(s -> s.withVerificationProgress(done, total));
        }
    }

    @Override
    public void coarseRendered(Film film, Scene scene) {
        updateCanvas(() -> canvas.coarseRendered(film, scene));
        publish(s -> s);
    }

    @Override
    public void tileRendered(Scene scene, int tile, float[][] film) {
        updateCanvas(() -> canvas.tileRendered(scene, tile, film));
    }

    @Override
    public void rendered(Frame frame) {
        updateCanvas(() -> canvas.rendered(frame));
        changeState(s -> s.withFrame(frame));
    }

    @Override
    public synchronized void pictureDropped(long number) {
        currentDocument = number;
    }

    @Override
    public void savingMeasured(WarmSaving saving) {
        canvas.savingMeasured(saving);
        publish(s -> s.withSaving(saving));
    }

    @Override
    public void verified(Verification verification) {
        canvas.verified(verification);
        publish(s -> s.withVerification(verification));
    }

    @Override
    public void canceled() {
        canvas.canceled();
        publish(s -> s.withStop(null));
    }

    @Override
    public void failed(Throwable problem) {
        canvas.failed(problem);
        publish(s -> s.withStop(problem));
    }

    @Override
    public void workRemaining() {
        publish(s -> s);
    }

    @Override
    public void idle() {
        updateCanvas(canvas::idle);
        publish(s -> s);
    }
}
