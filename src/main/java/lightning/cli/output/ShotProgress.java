package lightning.cli.output;

import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import org.jspecify.annotations.Nullable;

/** Updates all frames of a shot to one revision after another, and reports the progress. */
public final class ShotProgress implements ShotListener {
    private final int count;
    private final AtomicInteger done = new AtomicInteger();
    private final AtomicInteger traced = new AtomicInteger();
    private final AtomicLong rays = new AtomicLong();
    private final AtomicLong nanoseconds = new AtomicLong();
    private final AtomicReference<Throwable> problem = new AtomicReference<>();
    private volatile @Nullable Consumer<FrameUpdate> frameConsumer;
    private volatile @Nullable ProgressBar bar;

    /**
     * Creates the progress of a shot.
     *
     * @param count number of frames of the shot
     */
    public ShotProgress(int count) {
        this.count = count;
    }

    /**
     * Updates all frames to a revision; returns the time in milliseconds, including the consumer's.
     *
     * @param title title of the progress bar
     * @param consumer called with each frame on the shot's threads
     * @throws InterruptedException if the command is canceled
     * @throws Exception the failure of a frame
     */
    public double run(ShotRelighter shot, ShotRevision revision, Console console, String title, @Nullable Consumer<FrameUpdate> consumer)
            throws Exception {
        long start = System.nanoTime();
        done.set(0);
        traced.set(0);
        rays.set(0);
        nanoseconds.set(0);
        try (ProgressBar progressBar = new ProgressBar(console, title)) {
            frameConsumer = consumer;
            bar = progressBar;
            shot.setRevision(revision);
            shot.awaitIdle();
            bar = null;
        }
        switch (problem.get()) {
            case null -> {}
            case Exception e -> throw e;
            case Error e -> throw e;
            case Throwable e -> throw new IllegalStateException(e);
        }
        return (System.nanoTime() - start) / 1e6;
    }

    /** Returns the number of frames traced for the last revision. */
    public int tracedCount() {
        return traced.get();
    }

    public long rayCount() {
        return rays.get();
    }

    /** Returns the sum of all frames' times for the last revision, in milliseconds. */
    public double workMilliseconds() {
        return nanoseconds.get() / 1e6;
    }

    @Override
    public void frameUpdated(FrameUpdate update, FrameState state) {
        traced.addAndGet(update.traced() ? 1 : 0);
        rays.addAndGet(update.rays());
        nanoseconds.addAndGet(update.nanoseconds());
        Consumer<FrameUpdate> consumer = frameConsumer;
        if (consumer != null) {
            consumer.accept(update);
        }
        ProgressBar progressBar = bar;
        int finished = done.incrementAndGet();
        if (progressBar != null) {
            progressBar.report(finished, count);
        }
    }

    @Override
    public void frameFailed(int frame, Throwable failure) {
        if (!(failure instanceof CancellationException)) {
            problem.compareAndSet(null, failure);
        }
    }
}
