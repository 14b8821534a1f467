package lightning.document.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import lightning.base.work.Progress;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Display of an image while it is rendered. A fast update appears only when it is complete. A slow one is replaced by a coarse image of its
 * scene, over which its finished tiles appear, so that no part of the display shows an older scene. Thread-safe.
 */
final class ProgressiveDisplay implements Progress {
    /** Time after which an update's duration is estimated, in nanoseconds. */
    private static final long ESTIMATE_NS = 80_000_000;
    /** Minimum remaining time of a slow update, in nanoseconds. */
    static final long SLOW_NS = 250_000_000;

    /** Inverse of the share of the work from which a newer scene no longer replaces an update that keeps its work. */
    private static final int KEPT_SHARE = 4;

    /** Finished tile that is not shown yet. */
    private record FinishedTile(int number, float[][] film) {}

    /** Listener for whether a newer scene should replace the update, rather than wait for it. */
    interface ReplaceableListener {
        void setReplaceable(boolean isReplaceable);
    }

    /** Newer scene that waits until the work on this one is done. */
    interface WaitingScene {
        /** Shows a coarse image of the newest waiting scene; returns false if there is none, or it is shown already. */
        boolean show();
    }

    private final Progress signal;
    private final Scene scene;
    private final RenderListener listener;
    private final Runnable slowListener;
    private final ReplaceableListener replaceable;
    private final boolean canShow;
    private final LongSupplier clock;
    private final long startNs;
    private final AtomicBoolean slow = new AtomicBoolean();
    /** As {@link #displayNs()}. */
    private final AtomicLong displayNs = new AtomicLong();
    private final List<FinishedTile> waiting = new ArrayList<>();
    private boolean showsTiles;
    private volatile boolean showsScene;
    /** Null if a newer scene always replaces this one. */
    private @Nullable WaitingScene waitingScene;
    /** True if the display shows a waiting scene. */
    private boolean isOutdated;

    /**
     * @param signal      receives progress, and cancels the update
     * @param slowListener called at the first sign that the update is slow, on the thread of a tile; shows a coarse image of the scene
     * @param replaceable notified once the display shows the scene
     * @param canShow     false if the display shows another view than the tiles
     */
    ProgressiveDisplay(Progress signal, Scene scene, RenderListener listener, Runnable slowListener, ReplaceableListener replaceable,
            boolean canShow) {
        this(signal, scene, listener, slowListener, replaceable, canShow, System::nanoTime);
    }

    /** @param clock time in nanoseconds */
    ProgressiveDisplay(Progress signal, Scene scene, RenderListener listener, Runnable slowListener, ReplaceableListener replaceable,
            boolean canShow, LongSupplier clock) {
        this.signal = signal;
        this.scene = scene;
        this.listener = listener;
        this.slowListener = slowListener;
        this.replaceable = replaceable;
        this.canShow = canShow;
        this.clock = clock;
        startNs = clock.getAsLong();
    }

    /** Shows tiles from the start: the display shows the scene already, or is empty. */
    ProgressiveDisplay showingTiles(boolean isSceneShown) {
        slow.set(true);
        showTiles();
        showsScene = isSceneShown;
        return this;
    }

    /** Keeps the work from a quarter on: a newer scene is then shown coarsely, and follows as an update. */
    ProgressiveDisplay keepingWork(WaitingScene newer) {
        waitingScene = newer;
        return this;
    }

    @Override
    public void report(int done, int total) {
        signal.report(done, total);
        long elapsed = clock.getAsLong() - startNs;
        boolean isLong = elapsed > ESTIMATE_NS && remaining(elapsed, done, total) > SLOW_NS;
        if (isLong && slow.compareAndSet(false, true)) {
            measure(slowListener);
            if (canShow) {
                measure(this::showTiles);
                showsScene = true;
            }
        }
        if (showsScene) {
            boolean isSlow = remaining(elapsed, done, total) > SLOW_NS;
            WaitingScene newer = KEPT_SHARE * (long) done < total ? null : waitingScene;
            replaceable.setReplaceable(isSlow && newer == null);
            if (isSlow && newer != null && newer.show()) {
                endTiles();
            }
        }
    }

    /** Runs a task on the thread of a tile whose time is none of the update's. */
    private void measure(Runnable task) {
        long start = clock.getAsLong();
        task.run();
        displayNs.addAndGet(clock.getAsLong() - start);
    }

    /** Returns the time that all threads spent on showing tiles and coarse images, and on waiting for each other meanwhile, in nanoseconds. */
    long displayNs() {
        return displayNs.get();
    }

    private synchronized void endTiles() {
        isOutdated = true;
    }

    private static double remaining(long elapsed, int done, int total) {
        return (double) elapsed * (total - done) / done;
    }

    private synchronized void showTiles() {
        showsTiles = true;
        waiting.forEach(tile -> listener.tileRendered(scene, tile.number, tile.film));
        waiting.clear();
    }

    @Override
    public void tileFinished(int tile, float[][] film) {
        measure(() -> show(tile, film));
    }

    private synchronized void show(int tile, float[][] film) {
        if (!canShow || isOutdated) {
            return;
        }
        if (showsTiles) {
            listener.tileRendered(scene, tile, film);
        } else {
            waiting.add(new FinishedTile(tile, film));
        }
    }

    @Override
    public void raysCast(long count) {
        signal.raysCast(count);
    }

    @Override
    public boolean isCanceled() {
        return signal.isCanceled();
    }
}
