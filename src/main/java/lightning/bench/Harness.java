package lightning.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.bench.accuracy.Bandwidth;
import lightning.bench.accuracy.BrokenPromise;
import lightning.bench.accuracy.LadderMeter;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.tile.Options;

/**
 * A run: measures scenes, part by part.
 *
 * <p>What cannot be measured becomes a {@link Failure} and costs that part alone. After each part the results until then
 * are handed on, so that a run that is cancelled leaves what it has.
 */
public final class Harness {
    private static final int DRIFT_EDITS = 10_000;
    private static final int QUICK_DRIFT_EDITS = 100;
    private static final PictureSize DRIFT_SIZE = new PictureSize(96, 96);
    /** For how long the first scene is traced at least before anything is measured. */
    private static final double COLD_MS = 2000;
    private static final double PACE_MS = 250;
    private static final double WARM_UP_MS = 3000;
    private static final double QUICK_WARM_UP_MS = 1500;

    /** Hears of a run while it goes on. */
    public interface Listener {
        /** What was measured until now; the last part is the last in it. */
        void measured(String part, Results results) throws IOException;
    }

    private final Settings settings;
    private final List<NamedScene> scenes;
    private final Ledger ledger = new Ledger();
    private final List<Group> groups = new ArrayList<>();
    private final List<Double> triad;
    private final double predictedMs;
    private final long begin = System.nanoTime();
    private final LoadMeter load = new LoadMeter();
    private final Run run;

    /** Parts that share something, which is closed after the last. */
    private record Group(List<Part> parts, AutoCloseable shared) {}

    /**
     * Prepares a run: lets the compiler see the first scene's edits, measures the bandwidth of memory, traces each scene for a
     * moment, and predicts how long all will take.
     *
     * @param scenes    in the order in which they are measured; their names differ
     * @param problems  of scenes that could not be read
     * @param folder    where pictures go
     * @param arguments the command's, to be written down
     * @throws PictureTooLarge       if no scene fits into memory at any size; where some do, the others become problems. Asked
     *                               before anything is measured
     * @throws CancellationException if {@code progress} asked to stop
     */
    public Harness(Settings settings, List<NamedScene> scenes, List<Failure> problems, Path folder, List<String> arguments,
            Progress progress) {
        this.settings = settings;
        this.scenes = List.copyOf(scenes);
        problems.forEach(ledger::problem);
        Set<Measurable> fitting = fitting();
        List<Pace> paces = new ArrayList<>();
        try (Workers workers = new Workers(settings.threads())) {
            triad = Bandwidth.triad(workers, settings.isWarm() ? Bandwidth.REPETITIONS : 1);
            warmUp(workers, progress.silent());
            double leastMs = settings.isWarm() ? PACE_MS : 0;
            scenes.forEach(scene -> paces.add(Pace.of(scene.scene(), workers, leastMs, progress.silent())));
        }
        double best = triad.stream().mapToDouble(d -> d).max().orElseThrow();
        for (int i = 0; i < scenes.size(); i++) {
            add(scenes.get(i), paces.get(i), fitting, best, new Pictures(folder));
        }
        if (settings.curves() && !scenes.isEmpty()) {
            groups.add(new Group(new GrowthBench(settings, ledger, best).parts(paces.getFirst()), () -> {}));
            groups.add(new Group(List.of(drift(paces.getFirst())), () -> {}));
        }
        if (settings.editing()) {
            groups.add(new Group(new EditingBench(settings, ledger).parts(), () -> {}));
        }
        if (settings.meshes()) {
            groups.add(new Group(new MeshBench(settings, ledger).parts(), () -> {}));
        }
        predictedMs = groups.stream().flatMap(g -> g.parts().stream()).mapToDouble(Part::predictedMs).sum();
        run = new Run(Instant.now().truncatedTo(ChronoUnit.SECONDS).toString(), Here.commit(), arguments, Here.machine(), load.load(),
                settings.seed(), settings.threads(), settings.repetitions(), settings.quick(), predictedMs / 1e3, 0, false, best / 1e6,
                triad.stream().map(d -> d / 1e6).toList());
    }

    /** A scene at a size. */
    private record Measurable(NamedScene scene, PictureSize size) {}

    /** What fits into memory; the rest becomes problems, and if that is all there is, nothing begins. */
    private Set<Measurable> fitting() {
        Set<Measurable> fitting = new HashSet<>();
        PictureTooLarge refusal = null;
        for (NamedScene scene : scenes) {
            for (PictureSize size : settings.sizes()) {
                try {
                    MemoryNeed.check(size.of(scene.scene()), Options.DEFAULT.withThreads(settings.threads()));
                    fitting.add(new Measurable(scene, size));
                } catch (PictureTooLarge e) {
                    refusal = e;
                    ledger.problem(new Failure(Failure.Kind.UNMEASURED, scene.name() + " at " + size, e.getMessage()));
                }
            }
        }
        if (refusal != null && fitting.isEmpty()) {
            throw refusal;
        }
        return fitting;
    }

    private void add(NamedScene scene, Pace pace, Set<Measurable> fitting, double bytesPerMs, Pictures pictures) {
        for (PictureSize size : settings.sizes()) {
            if (!fitting.contains(new Measurable(scene, size))) {
                continue;
            }
            Ledger.Page page = ledger.page(scene, size);
            SceneBench bench = new SceneBench(settings, ledger, page, scene, size, bytesPerMs,
                    size.equals(settings.sizes().getFirst()) ? pictures : null);
            List<Part> parts = new ArrayList<>(bench.parts(pace, size));
            if (settings.peers()) {
                PovPeer.find().ifPresent(peer -> parts.add(peer.part(settings, ledger, page, scene, size, pace)));
            }
            if (settings.processes() > 0 && scene.file() != null) {
                parts.add(new ColdBench(settings, ledger).part(page, scene, size, pace));
            }
            groups.add(new Group(parts, bench));
        }
    }

    private Part drift(Pace pace) {
        int edits = settings.quick() ? QUICK_DRIFT_EDITS : DRIFT_EDITS;
        DriftBench drift = new DriftBench(scenes.getFirst(), DRIFT_SIZE, settings.threads(), settings.seed());
        return new Part("drift over " + edits + " edits", edits * (pace.fullMs(DRIFT_SIZE) + 1),
                progress -> ledger.drift(drift.measure(edits, progress)));
    }

    /** How long the run will take, seconds, good to about a factor of two. */
    public double predictedSeconds() {
        return predictedMs / 1e3;
    }

    /** What was measured until now. */
    public Results results(boolean complete) {
        return ledger.results(run.after((System.nanoTime() - begin) / 1e9, complete, load.load()));
    }

    /**
     * Measures everything.
     *
     * @param progress hears how much of the predicted time is over
     * @return the results
     * @throws IOException              if results or pictures cannot be written
     * @throws InterruptedException     if this thread was interrupted while another program ran
     * @throws CancellationException    if {@code progress} asked to stop; {@link #results} still has what was measured
     */
    public Results run(Listener listener, Progress progress) throws IOException, InterruptedException {
        double done = 0;
        for (Group group : groups) {
            try (AutoCloseable _ = group.shared()) {
                for (Part part : group.parts()) {
                    measure(part, new Share(progress, done / predictedMs, part.predictedMs() / predictedMs));
                    done += part.predictedMs();
                    listener.measured(part.where(), results(false));
                }
            } catch (IOException | InterruptedException | RuntimeException e) {
                throw e;
            } catch (Exception e) {
                throw new IllegalStateException("closing cannot fail", e);
            }
        }
        return results(true);
    }

    private void measure(Part part, Progress progress) throws IOException, InterruptedException {
        progress.tiles(0, 1);
        try {
            part.work().measure(progress);
        } catch (BrokenPromise e) {
            ledger.problem(new Failure(Failure.Kind.BROKEN, part.where(), e.getMessage()));
        } catch (PictureTooLarge e) {
            ledger.problem(new Failure(Failure.Kind.UNMEASURED, part.where(), e.getMessage()));
        } catch (OutOfMemoryError e) {
            ledger.problem(new Failure(Failure.Kind.UNMEASURED, part.where(), "there is not enough memory for it"));
        }
    }

    /** Lets the compiler see the first scene's edits. */
    private void warmUp(Workers workers, Progress progress) {
        if (scenes.isEmpty() || !settings.isWarm()) {
            return;
        }
        Pace.of(scenes.getFirst().scene(), workers, COLD_MS, progress);
        double patienceMs = settings.quick() ? QUICK_WARM_UP_MS : WARM_UP_MS;
        var scene = new PictureSize(160, 120).of(scenes.getFirst().scene());
        long start = System.nanoTime();
        try (LadderMeter meter = new LadderMeter(settings.threads(), 1, 0)) {
            for (PaperCase edit : PaperCases.of(scene)) {
                if ((System.nanoTime() - start) / 1e6 < patienceMs) {
                    meter.measure(scene, edit.after(), progress);
                }
            }
        } catch (BrokenPromise e) {
            // The part that measures it will say so.
        }
    }
}
