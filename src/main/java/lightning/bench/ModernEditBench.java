package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.accuracy.UpdateSaving;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.ModernEdit;
import lightning.bench.result.ModernSampling;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;

/** Benchmark of the first pass and the edits of a modern scene, at the default accuracy setting. */
record ModernEditBench(BenchSettings settings, ResultCollector ledger, double bytesPerMs) {
    /** Sizes from the largest; the first whose full trace is fast enough is measured, otherwise the last. */
    private static final List<PictureSize> SIZES = List.of(new PictureSize(640, 360), new PictureSize(320, 180), new PictureSize(160, 90));
    private static final double MAX_TRACE_MS = 700;
    /** Typical duration in full traces: first passes, verification, warm-up and samples. */
    private static final double PREDICTED_TRACES = 25;
    private static final double PREDICTED_TRACE_MS = 600;

    double predictedMs() {
        return PREDICTED_TRACES * (settings.quick() ? PREDICTED_TRACE_MS / 10 : PREDICTED_TRACE_MS);
    }

    void measure(ModernCollector collector, NamedScene named, ModernSampling sampling, Progress progress) {
        Progress silent = progress.cancellationOnly();
        Scene unsized = sampling.of(named.scene());
        PictureSize size = settings.quick() ? SIZES.getLast() : fittingSize(unsized, silent);
        Scene scene = size.of(unsized);
        try (UpdateSavingMeter meter = new UpdateSavingMeter(RenderOptions.DEFAULT.withThreads(settings.threads()), settings.repetitions(),
                settings.patienceMs(), bytesPerMs)) {
            FirstPassCost first = meter.firstPass(scene, silent);
            List<PaperCase> cases = ModernCases.of(scene);
            List<UpdateSaving> savings = meter.updates(scene, cases.stream().map(PaperCase::after).toList(), silent);
            List<ModernEdit> edits = new ArrayList<>();
            for (int i = 0; i < cases.size(); i++) {
                edits.add(ModernEdit.of(cases.get(i), savings.get(i)));
                if (!edits.getLast().equal()) {
                    ledger.addBroken(named.name() + ", anti-aliasing " + sampling.label() + ", " + cases.get(i).name(),
                            "the image is not equal to a full trace");
                }
            }
            double savedMs = edits.stream().mapToDouble(edit -> edit.fullTrace().median() - edit.time().median()).average().orElse(0);
            collector.setEdits(sampling, size, FirstPassResult.of(first, size.pixels(), savedMs), edits);
        }
    }

    /** Returns the largest size whose full trace is fast enough, predicted from the smallest. */
    private PictureSize fittingSize(Scene scene, Progress progress) {
        PictureSize smallest = SIZES.getLast();
        try (WorkerPool workers = new WorkerPool(settings.threads())) {
            TraditionalTracer tracer = new TraditionalTracer(smallest.of(scene)).withEngines(Engines.FASTEST);
            tracer.trace(workers, progress);
            long start = System.nanoTime();
            tracer.trace(workers, progress);
            double msPerPixel = (System.nanoTime() - start) / 1e6 / smallest.pixels();
            return SIZES.stream().filter(size -> msPerPixel * size.pixels() <= MAX_TRACE_MS).findFirst().orElse(smallest);
        }
    }
}
