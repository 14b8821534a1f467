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
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.MemoryBandwidth;
import lightning.bench.result.BenchResults;
import lightning.bench.result.BenchRun;
import lightning.bench.result.MeasurementFailure;
import lightning.render.RenderOptions;
import lightning.render.measure.AccuracySweepMeter;
import lightning.render.measure.GuaranteeViolation;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;

/**
 * Benchmark run over scenes, part by part.
 *
 * <p>A failed measurement becomes a {@link MeasurementFailure} and affects only its part. The harness reports results after each part, so
 * that a canceled run keeps its results.
 */
public final class Harness {
    private static final int DRIFT_EDITS = 10_000;
    private static final int QUICK_DRIFT_EDITS = 100;
    private static final PictureSize DRIFT_SIZE = new PictureSize(96, 96);
    /** Minimum time of tracing the first scene before any measurement. */
    private static final double JIT_WARM_UP_MS = 2000;
    private static final double THROUGHPUT_MS = 250;
    private static final double WARM_UP_MS = 3000;
    private static final double QUICK_WARM_UP_MS = 1500;

    /** Listener for progress of a run. */
    public interface Listener {
        /** Receives the results so far; those of the finished part are last. */
        void partMeasured(String part, BenchResults results) throws IOException;
    }

    private final BenchSettings settings;
    private final List<NamedScene> scenes;
    private final ResultCollector ledger = new ResultCollector();
    private final List<PartGroup> groups = new ArrayList<>();
    private final List<Double> triad;
    private final double predictedMs;
    private final long startNs = System.nanoTime();
    private final SystemLoadMeter loadMeter = new SystemLoadMeter();
    private final BenchRun run;

    /** Parts with a shared resource, closed after the last part. */
    private record PartGroup(List<BenchPart> parts, AutoCloseable shared) {}

    /**
     * Prepares a run: warms up with the first scene's edits, measures memory bandwidth, traces each scene briefly, and predicts the total
     * duration.
     *
     * @param originals scenes in order of measurement, with unique names; only the part of indirect light shows theirs
     * @param problems  scenes that could not be read
     * @param folder    folder for images
     * @param arguments command arguments, for the results
     * @throws PictureTooLargeException if no scene fits into memory at any size. If some do, the others become failed measurements. Checked
     *         before any measurement
     * @throws CancellationException    if {@code progress} requests a stop
     */
    public Harness(BenchSettings settings, List<NamedScene> originals, List<MeasurementFailure> problems, Path folder,
            List<String> arguments,
            Progress progress) {
        this.settings = settings;
        scenes = originals.stream().map(NamedScene::withoutGatheredLight).toList();
        problems.forEach(ledger::addProblem);
        Set<Measurable> measurable = measurableScenes();
        List<TraceThroughput> throughputs = new ArrayList<>();
        try (WorkerPool workers = new WorkerPool(settings.threads())) {
            triad = MemoryBandwidth.triad(workers, settings.isWarm() ? MemoryBandwidth.REPETITIONS : 1);
            warmUp(workers, progress.cancellationOnly());
            double minMs = settings.isWarm() ? THROUGHPUT_MS : 0;
            scenes.forEach(scene -> throughputs.add(TraceThroughput.measure(scene.scene(), workers, minMs, progress.cancellationOnly())));
        }
        double bestBytesPerMs = triad.stream().mapToDouble(d -> d).max().orElseThrow();
        for (int i = 0; i < scenes.size(); i++) {
            add(scenes.get(i), throughputs.get(i), measurable, bestBytesPerMs, new PictureWriter(folder));
        }
        if (settings.curves() && !scenes.isEmpty()) {
            groups.add(new PartGroup(new GrowthBench(settings, ledger, bestBytesPerMs).parts(throughputs.getFirst()), () -> {}));
            groups.add(new PartGroup(List.of(drift(throughputs.getFirst())), () -> {}));
        }
        if (settings.editing()) {
            groups.add(new PartGroup(new EditingBench(settings, ledger).parts(), () -> {}));
        }
        if (settings.meshes()) {
            groups.add(new PartGroup(new MeshBench(settings, ledger).parts(), () -> {}));
        }
        for (int i = 0; settings.modern() && i < scenes.size(); i++) {
            groups.add(new PartGroup(new ModernBench(settings, ledger, scenes.get(i), bestBytesPerMs).parts(throughputs.get(i)), () -> {}));
        }
        if (settings.indirect()) {
            new IndirectBench(settings, ledger).parts(originals).forEach(part -> groups.add(new PartGroup(List.of(part), () -> {})));
            new ReflectionBench(settings, ledger).parts(originals).forEach(part -> groups.add(new PartGroup(List.of(part), () -> {})));
            new SoftShadowBench(settings, ledger).parts(originals).forEach(part -> groups.add(new PartGroup(List.of(part), () -> {})));
        }
        predictedMs = groups.stream().flatMap(g -> g.parts().stream()).mapToDouble(BenchPart::predictedMs).sum();
        run = new BenchRun(Instant.now().truncatedTo(ChronoUnit.SECONDS).toString(), MachineInfo.commit(), arguments, MachineInfo.machine(),
                loadMeter.current(),
                settings.seed(), settings.threads(), settings.repetitions(), settings.quick(), predictedMs / 1e3, 0, false,
                bestBytesPerMs / 1e6,
                triad.stream().map(d -> d / 1e6).toList());
    }

    /** Scene at one size. */
    private record Measurable(NamedScene scene, PictureSize size) {}

    /** Returns the scenes that fit into memory; the others become failed measurements. Throws if none fits. */
    private Set<Measurable> measurableScenes() {
        Set<Measurable> measurable = new HashSet<>();
        PictureTooLargeException tooLarge = null;
        for (NamedScene scene : scenes) {
            for (PictureSize size : settings.sizes()) {
                try {
                    MemoryEstimate.check(size.of(scene.scene()), RenderOptions.DEFAULT.withThreads(settings.threads()));
                    measurable.add(new Measurable(scene, size));
                } catch (PictureTooLargeException e) {
                    tooLarge = e;
                    ledger.addUnmeasured(scene.name() + " at " + size, e.getMessage());
                }
            }
        }
        if (tooLarge != null && measurable.isEmpty()) {
            throw tooLarge;
        }
        return measurable;
    }

    private void add(NamedScene scene, TraceThroughput throughput, Set<Measurable> measurable, double bytesPerMs, PictureWriter pictures) {
        for (PictureSize size : settings.sizes()) {
            if (!measurable.contains(new Measurable(scene, size))) {
                continue;
            }
            ResultCollector.SceneCollector collector = ledger.addScene(scene, size);
            SceneBench bench = new SceneBench(settings, ledger, collector, scene, size, bytesPerMs,
                    size.equals(settings.sizes().getFirst()) ? pictures : null);
            List<BenchPart> parts = new ArrayList<>(bench.parts(throughput, size));
            if (settings.peers()) {
                PovRayBench.find().ifPresent(peer -> parts.add(peer.part(settings, ledger, collector, scene, size, throughput)));
            }
            if (settings.processes() > 0 && scene.file() != null) {
                parts.add(new ColdStartBench(settings, ledger).part(collector, scene, size, throughput));
            }
            groups.add(new PartGroup(parts, bench));
        }
    }

    private BenchPart drift(TraceThroughput throughput) {
        int edits = settings.quick() ? QUICK_DRIFT_EDITS : DRIFT_EDITS;
        DriftBench drift = new DriftBench(scenes.getFirst(), DRIFT_SIZE, settings.threads(), settings.seed());
        return new BenchPart("drift over " + edits + " edits", edits * (throughput.fullMs(DRIFT_SIZE) + 1),
                progress -> ledger.addDrift(drift.measure(edits, progress)));
    }

    /** Returns the predicted duration in seconds, accurate to about a factor of two. */
    public double predictedSeconds() {
        return predictedMs / 1e3;
    }

    /** Returns the results so far. */
    public BenchResults results(boolean complete) {
        return ledger.results(run.withOutcome((System.nanoTime() - startNs) / 1e9, complete, loadMeter.current()));
    }

    /**
     * Runs all measurements.
     *
     * @param progress receives the share of the predicted duration
     * @return the results
     * @throws IOException           if results or images cannot be written
     * @throws InterruptedException  if this thread was interrupted while another program ran
     * @throws CancellationException if {@code progress} requests a stop; {@link #results} has the results so far
     */
    public BenchResults run(Listener listener, Progress progress) throws IOException, InterruptedException {
        double doneMs = 0;
        for (PartGroup group : groups) {
            try (AutoCloseable _ = group.shared()) {
                for (BenchPart part : group.parts()) {
                    double startMs = doneMs;
                    doneMs += part.predictedMs();
                    measure(part, new ProgressPart(progress, startMs / predictedMs, doneMs / predictedMs));
                    listener.partMeasured(part.where(), results(false));
                }
            } catch (IOException | InterruptedException | RuntimeException e) {
                throw e;
            } catch (Exception e) {
                throw new IllegalStateException("closing cannot fail", e);
            }
        }
        return results(true);
    }

    private void measure(BenchPart part, Progress progress) throws IOException, InterruptedException {
        progress.report(0, 1);
        try {
            part.work().measure(progress);
        } catch (GuaranteeViolation e) {
            ledger.addBroken(part.where(), e.getMessage());
        } catch (PictureTooLargeException e) {
            ledger.addUnmeasured(part.where(), e.getMessage());
        } catch (OutOfMemoryError e) {
            ledger.addUnmeasured(part.where(), "not enough memory");
        }
    }

    /** Warms up the JIT compiler with the first scene's edits. */
    private void warmUp(WorkerPool workers, Progress progress) {
        if (scenes.isEmpty() || !settings.isWarm()) {
            return;
        }
        TraceThroughput.measure(scenes.getFirst().scene(), workers, JIT_WARM_UP_MS, progress);
        double maxMs = settings.quick() ? QUICK_WARM_UP_MS : WARM_UP_MS;
        var scene = new PictureSize(160, 120).of(scenes.getFirst().scene());
        long start = System.nanoTime();
        try (AccuracySweepMeter meter = new AccuracySweepMeter(settings.threads(), 1, 0)) {
            for (PaperCase edit : PaperCases.of(scene)) {
                if ((System.nanoTime() - start) / 1e6 < maxMs) {
                    meter.measure(scene, edit.after(), progress);
                }
            }
        } catch (GuaranteeViolation e) {
            // Reported by the part that measures it.
        }
    }
}
