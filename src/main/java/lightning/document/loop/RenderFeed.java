package lightning.document.loop;

import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import lightning.render.image.Film;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Forwards events of a render loop to the window's thread. Coalesces events, so that the window handles only the newest state. Delivers a
 * finished image together with the remaining-work event, as each delivery updates all panes. Drops events of documents that are no longer
 * open.
 */
public final class RenderFeed implements RenderListener {
    /** Minimum interval between progress reports, in nanoseconds. Each report takes processor time from the render. */
    private static final long REPORT_INTERVAL_NS = 40_000_000;

    private final Executor window;
    private final RenderListener canvas;
    private final Runnable stateListener;
    private final AtomicBoolean notificationPending = new AtomicBoolean();
    /** Time of the last progress report or job start. */
    private final AtomicLong lastReportNs = new AtomicLong(System.nanoTime());
    /** Guards the canvas, so that it is cleared after the last draw of the previous document. */
    private final Object canvasLock = new Object();
    private final RayCounter rays = new RayCounter(System::nanoTime);
    private RenderState state = RenderState.NONE;
    /** Number of the open document, and of the document for which the loop has dropped all earlier ones. */
    private long openDocument;
    private long currentDocument;

    /**
     * @param window        runs tasks in order on the window's thread
     * @param canvas        receives all events on the loop's threads, before the window does
     * @param stateListener called on the window's thread after a change of the state
     */
    public RenderFeed(Executor window, RenderListener canvas, Runnable stateListener) {
        this.window = window;
        this.canvas = canvas;
        this.stateListener = stateListener;
    }

    /** Returns the newest state. */
    public synchronized RenderState state() {
        return state;
    }

    /** Switches to another document. {@link #pictureDropped} with its number reports that the loop has dropped the previous one. */
    public void open(long number) {
        synchronized (this) {
            openDocument = number;
            state = RenderState.NONE;
        }
        synchronized (canvasLock) {
            canvas.pictureDropped(number);
        }
    }

    /** Marks a pending render as canceled, even if the loop has not dropped the previous document yet. */
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

    /** Returns whether the event belongs to the open document. */
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

    /** Returns whether the minimum interval since the last progress report has passed. The end of a job is always reported. */
    private boolean isReportDue(int done, int total) {
        long last = lastReportNs.get();
        long now = System.nanoTime();
        return done == total || now - last > REPORT_INTERVAL_NS && lastReportNs.compareAndSet(last, now);
    }

    @Override
    public void started(UpdatePlan plan) {
        lastReportNs.set(System.nanoTime());
        rays.start(RenderActivity.Stage.CENTERS);
        canvas.started(plan);
        publish(s -> s.withPlan(plan).withActivity(rays.activity()));
    }

    @Override
    public void indirectStarted() {
        canvas.indirectStarted();
        startStage(RenderActivity.Stage.INDIRECT);
    }

    @Override
    public void samplesStarted() {
        canvas.samplesStarted();
        startStage(RenderActivity.Stage.SAMPLES);
    }

    private void startStage(RenderActivity.Stage stage) {
        lastReportNs.set(System.nanoTime());
        rays.start(stage);
        publish(s -> s.withProgress(0, 0).withActivity(rays.activity()));
    }

    @Override
    public void raysCast(long count) {
        rays.add(count);
    }

    @Override
    public void progress(int done, int total) {
        canvas.progress(done, total);
        if (done == total) {
            // Reported together with the result.
            changeState(s -> s.withProgress(done, total));
        } else if (isReportDue(done, total)) {
            publish(s -> s.withProgress(done, total).withActivity(rays.activity()));
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
        publish(s -> s.withMeasuredSaving(saving));
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
