package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import lightning.base.work.OwnThread;
import lightning.render.image.Film;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.KeeperGoneException;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;
import lightning.shot.Take;
import lightning.shot.cluster.DistributedShot;
import lightning.shot.cluster.Place;
import lightning.shot.movie.FrameFiles;

/**
 * Makes edits in all frames of a shot that nodes of a cluster hold, and writes their pictures.
 *
 * @param folder  the folder that holds the scene file
 * @param threads how many pictures are written at once
 */
record RelightElsewhere(Console console, PictureOutput output, Place place, Path folder, int threads) {
    /** How long the command waits for a first node: for two tries to find one. */
    private static final long FIRST_PATIENCE_NANOSECONDS = 30_000_000_000L;
    /** How long it waits for another one where all are gone: one may be started again. */
    private static final long PATIENCE_NANOSECONDS = 60_000_000_000L;
    private static final long LOOK_MILLISECONDS = 2;
    /** More than nodes are lost while one film is on its way. */
    private static final int MOST_ATTEMPTS = 100;

    /** What is heard of frames. */
    private static final class Tally implements ShotListener {
        /** Whether any node was there, as any of the waiting threads saw. */
        private volatile boolean met;
        private final Console console;
        private final AtomicInteger made = new AtomicInteger();
        private final AtomicInteger traced = new AtomicInteger();
        private final AtomicReference<Throwable> problem = new AtomicReference<>();

        Tally(Console console) {
            this.console = console;
        }

        @Override
        public void updated(FrameUpdate update, FrameState state) {
            made.incrementAndGet();
            traced.addAndGet(update.traced() ? 1 : 0);
        }

        @Override
        public void failed(int frame, Throwable failure) {
            problem.compareAndSet(null, new BadInput("frame " + frame + ": " + failure.getMessage()));
        }

        @Override
        public void gone(KeeperGoneException lost) {
            console.remark("%s", lost.getMessage());
        }
    }

    /**
     * Makes the edits of each group.
     *
     * @param groups where the pictures of each go
     * @throws BadInput if no node is there, or a frame cannot be made
     */
    void run(Take first, List<Take> edited, List<FrameFiles> groups, FrameRange range) throws Exception {
        var tally = new Tally(console);
        try (DistributedShot shot = DistributedShot.join(place, folder, range.first(), range.last(), tally,
                sentence -> console.remark("%s", sentence))) {
            double tracing = bring(shot, first, tally, "tracing");
            console.line("%s traced by %s in %.1f ms", Console.count(range.count(), "frame"), nodes(shot), tracing);
            for (int group = 0; group < edited.size(); group++) {
                long start = System.nanoTime();
                double relighting = bring(shot, edited.get(group), tally, "relighting");
                int traced = tally.traced.get();
                write(shot, groups.get(group), range, tally);
                console.line("%d. %s relit by %s in %.1f ms, %d of them traced again; %.1f ms with their pictures", group + 1,
                        Console.count(range.count(), "frame"), nodes(shot), relighting, traced, (System.nanoTime() - start) / 1e6);
            }
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }

    /** Brings all frames to a take; returns how long that took, milliseconds. */
    private double bring(DistributedShot shot, Take take, Tally tally, String what) throws Exception {
        long start = System.nanoTime();
        tally.made.set(0);
        tally.traced.set(0);
        try (ProgressBar bar = new ProgressBar(console, what)) {
            shot.frames().edit(take);
            await(shot, tally, bar);
        }
        return (System.nanoTime() - start) / 1e6;
    }

    private void await(DistributedShot shot, Tally tally, ProgressBar bar) throws Exception {
        RelitShot frames = shot.frames();
        int count = frames.last() - frames.first() + 1;
        long seen = System.nanoTime();
        while (!frames.isIdle()) {
            if (shot.machines() > 0) {
                seen = System.nanoTime();
                tally.met = true;
            } else if (System.nanoTime() - seen > (tally.met ? PATIENCE_NANOSECONDS : FIRST_PATIENCE_NANOSECONDS)) {
                throw new BadInput("no node answers at " + place.firstJoinText() + ": none is there, or it has another certificate");
            }
            bar.tiles(Math.min(tally.made.get(), count), count);
            Thread.sleep(LOOK_MILLISECONDS);
        }
        if (tally.problem.get() instanceof BadInput problem) {
            throw problem;
        }
    }

    private void write(DistributedShot shot, FrameFiles files, FrameRange range, Tally tally) throws Exception {
        List<Future<?>> pictures = new ArrayList<>();
        ExecutorService writers = Executors.newFixedThreadPool(threads, OwnThread.named("lightning-pictures"));
        try (ProgressBar bar = new ProgressBar(console, "writing")) {
            for (int frame = range.first(); frame <= range.last(); frame++) {
                int next = frame;
                pictures.add(writers.submit(() -> {
                    output.write(film(shot, next, tally, bar), files.file(next));
                    return null;
                }));
            }
            for (int i = 0; i < pictures.size(); i++) {
                pictures.get(i).get();
                bar.tiles(i + 1, pictures.size());
            }
        } catch (ExecutionException e) {
            throw e.getCause() instanceof Exception problem ? problem : e;
        } finally {
            writers.shutdownNow();
        }
    }

    /** The film of a frame; where the node that has it is lost meanwhile, another's. */
    private Film film(DistributedShot shot, int frame, Tally tally, ProgressBar bar) throws Exception {
        for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
            await(shot, tally, bar);
            var film = shot.frames().film(frame);
            if (film.isPresent() && shot.frames().state(frame) == FrameState.CURRENT) {
                return film.get();
            }
            Thread.sleep(LOOK_MILLISECONDS);
            if (Thread.interrupted()) {
                throw new InterruptedException();
            }
        }
        throw new BadInput("frame " + frame + ": no node had room to keep it; start more of them, or give them more --memory");
    }

    private static String nodes(DistributedShot shot) {
        return Console.count(shot.machines(), "node");
    }
}
