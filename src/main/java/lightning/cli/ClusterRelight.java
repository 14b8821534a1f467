package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.work.DedicatedThread;
import lightning.cli.option.FrameRange;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.ShotRelightReport;
import lightning.layer.FrameTime;
import lightning.render.image.Film;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.DistributedShot;
import lightning.shot.cluster.NodeConfig;
import lightning.shot.movie.FrameFiles;

/**
 * Applies edits to all frames of a shot on the nodes of a cluster, and writes their images.
 *
 * @param folder folder of the scene file
 * @param threads number of images written concurrently
 */
record ClusterRelight(Console console, PictureOutput output, NodeConfig config, Path folder, int threads) {
    /** Timeout for a first node: enough for two attempts to find one. Tests wait less. */
    private static final long FIRST_NODE_TIMEOUT_NANOSECONDS = TimeUnit.SECONDS.toNanos(Integer.getInteger("lightning.cluster.wait", 30));
    /** Timeout for another node after all were lost: one may be restarted. */
    private static final long NODE_TIMEOUT_NANOSECONDS = 60_000_000_000L;
    private static final long POLL_MILLISECONDS = 2;
    /** Exceeds the number of nodes lost while one film is transferred. */
    private static final int MAX_ATTEMPTS = 100;

    /** Receives the results of frames and counts them. */
    private static final class FrameCounts implements ShotListener {
        /** Set when any waiting thread has seen a node. */
        private volatile boolean sawNode;
        private final Console console;
        private final AtomicInteger updated = new AtomicInteger();
        private final AtomicInteger traced = new AtomicInteger();
        private final AtomicReference<Throwable> problem = new AtomicReference<>();

        FrameCounts(Console console) {
            this.console = console;
        }

        @Override
        public void frameUpdated(FrameUpdate update, FrameState state) {
            updated.incrementAndGet();
            traced.addAndGet(update.traced() ? 1 : 0);
        }

        @Override
        public void frameFailed(int frame, Throwable failure) {
            problem.compareAndSet(null, new BadInputException("frame " + frame + ": " + failure.getMessage()));
        }

        @Override
        public void hostLost(HostLostException lost) {
            console.warn("%s", lost.getMessage());
        }
    }

    /**
     * Applies the edits of each group.
     *
     * @param groups image files of each group
     * @throws BadInputException if no node is available, or a frame cannot be rendered
     */
    void run(ShotRevision original, List<ShotRevision> edited, List<FrameFiles> groups, FrameRange range) throws Exception {
        var counts = new FrameCounts(console);
        List<ShotRelightReport.Group> reports = new ArrayList<>();
        try (DistributedShot shot = DistributedShot.join(config, folder, range.first(), range.last(), counts,
                sentence -> console.warn("%s", sentence))) {
            double tracing = relightAll(shot, original, counts, "tracing");
            console.print("%s traced by %s in %.1f ms", Console.count(range.count(), "frame"), nodes(shot), tracing);
            for (int group = 0; group < edited.size(); group++) {
                long start = System.nanoTime();
                double relighting = relightAll(shot, edited.get(group), counts, "relighting");
                int traced = counts.traced.get();
                write(shot, edited.get(group), groups.get(group), range, counts);
                console.print("%d. %s relit by %s in %.1f ms, %d of them retraced; %.1f ms including images", group + 1,
                        Console.count(range.count(), "frame"), nodes(shot), relighting, traced, (System.nanoTime() - start) / 1e6);
                reports.add(new ShotRelightReport.Group(group + 1, groups.get(group).folder().toString(), relighting,
                        (System.nanoTime() - start) / 1e6, traced, null));
            }
            console.report().setResult(new ShotRelightReport(range.count(), shot.nodeCount(), tracing, reports, null, null, null));
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }

    /** Updates all frames to a revision; returns the time in milliseconds. */
    private double relightAll(DistributedShot shot, ShotRevision revision, FrameCounts counts, String title) throws Exception {
        long start = System.nanoTime();
        counts.updated.set(0);
        counts.traced.set(0);
        try (ProgressBar bar = new ProgressBar(console, title)) {
            shot.relighter().setRevision(revision);
            awaitFrames(shot, counts, bar);
        }
        return (System.nanoTime() - start) / 1e6;
    }

    private void awaitFrames(DistributedShot shot, FrameCounts counts, ProgressBar bar) throws Exception {
        ShotRelighter frames = shot.relighter();
        int count = frames.last() - frames.first() + 1;
        long lastSeen = System.nanoTime();
        while (!frames.isIdle()) {
            if (shot.nodeCount() > 0) {
                lastSeen = System.nanoTime();
                counts.sawNode = true;
            } else if (System.nanoTime() - lastSeen > (counts.sawNode ? NODE_TIMEOUT_NANOSECONDS : FIRST_NODE_TIMEOUT_NANOSECONDS)) {
                throw new BadInputException(
                        "no node answers at " + config.firstJoinText() + ": not running, or another certificate");
            }
            bar.report(Math.min(counts.updated.get(), count), count);
            Thread.sleep(POLL_MILLISECONDS);
        }
        if (counts.problem.get() instanceof BadInputException problem) {
            throw problem;
        }
    }

    private void write(DistributedShot shot, ShotRevision revision, FrameFiles files, FrameRange range, FrameCounts counts)
            throws Exception {
        List<Future<?>> pictures = new ArrayList<>();
        ExecutorService writers = Executors.newFixedThreadPool(threads, DedicatedThread.factory("lightning-pictures"));
        try (ProgressBar bar = new ProgressBar(console, "writing")) {
            for (int frame = range.first(); frame <= range.last(); frame++) {
                int next = frame;
                pictures.add(writers.submit(() -> {
                    output.write(revision.sceneAt(next), film(shot, next, counts, bar), files.file(next),
                            Optional.of(new FrameTime(next, revision.shot().rate())));
                    return null;
                }));
            }
            for (int i = 0; i < pictures.size(); i++) {
                pictures.get(i).get();
                bar.report(i + 1, pictures.size());
            }
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception problem ? problem : e;
        } finally {
            writers.shutdownNow();
        }
    }

    /** Returns the film of a frame; if its node is lost meanwhile, another node's film. */
    private Film film(DistributedShot shot, int frame, FrameCounts counts, ProgressBar bar) throws Exception {
        for (int attempt = 0; attempt < MAX_ATTEMPTS; attempt++) {
            awaitFrames(shot, counts, bar);
            var film = shot.relighter().film(frame);
            if (film.isPresent() && shot.relighter().state(frame) == FrameState.CURRENT) {
                return film.get();
            }
            Thread.sleep(POLL_MILLISECONDS);
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
        }
        throw new BadInputException("frame " + frame + ": no node has enough memory for it; start more nodes, or raise their --memory");
    }

    private static String nodes(DistributedShot shot) {
        return Console.count(shot.nodeCount(), "node");
    }
}
