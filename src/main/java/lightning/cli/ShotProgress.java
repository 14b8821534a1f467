package lightning.cli;

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

/** Brings all frames to one take after the other, and hears how far that is. */
final class ShotProgress implements ShotListener {
    private final int count;
    private final AtomicInteger done = new AtomicInteger();
    private final AtomicInteger traced = new AtomicInteger();
    private final AtomicLong rays = new AtomicLong();
    private final AtomicLong nanoseconds = new AtomicLong();
    private final AtomicReference<Throwable> problem = new AtomicReference<>();
    private volatile Consumer<FrameUpdate> frameConsumer;
    private volatile ProgressBar bar;

    /** @param count the frames of the shot */
    ShotProgress(int count) {
        this.count = count;
    }

    /**
     * Brings all frames to a take; returns how long that took with all that {@code consumer} did, milliseconds.
     *
     * @param title  for the bar
     * @param consumer of each frame, on the shot's threads; null for nobody
     * @throws InterruptedException if the command is canceled
     * @throws Exception            what a frame failed with
     */
    double run(ShotRelighter shot, ShotRevision revision, Console console, String title, Consumer<FrameUpdate> consumer) throws Exception {
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

    /** How many frames were traced for the last take, and the rays of all. */
    int tracedCount() {
        return traced.get();
    }

    long rayCount() {
        return rays.get();
    }

    /** What the frames of the last take took, one after the other, milliseconds. */
    double workMilliseconds() {
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
