package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.bench.accuracy.UpdateSaving;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.bench.result.GrowthPoint;
import lightning.bench.result.TimeSamples;
import lightning.render.RenderOptions;
import lightning.render.relight.MemoryEstimate;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;

/** Benchmark of edit times as a function of pixels, lights, shapes and reflection depth, on generated scenes. */
final class GrowthBench {
    private static final int SHAPES = 100;
    private static final int LIGHTS = 4;
    private static final int DEPTH = 2;

    private final BenchSettings settings;
    private final ResultCollector ledger;
    private final double bytesPerMs;
    /** Image size of all curves but that of pixels. */
    private final PictureSize fixedSize;

    GrowthBench(BenchSettings settings, ResultCollector ledger, double bytesPerMs) {
        this.settings = settings;
        this.ledger = ledger;
        this.bytesPerMs = bytesPerMs;
        // Functional tests set a small value.
        int side = Integer.getInteger("lightning.growth", 300);
        fixedSize = new PictureSize(side, side);
    }

    /** Returns the parts, one per point of each curve. */
    List<BenchPart> parts(TraceThroughput throughput) {
        List<BenchPart> parts = new ArrayList<>();
        List<PictureSize> sizes =
                settings.quick() ? List.of(new PictureSize(100, 100), new PictureSize(200, 200), new PictureSize(400, 400))
                        : List.of(new PictureSize(100, 100), new PictureSize(200, 200), new PictureSize(400, 400),
                                new PictureSize(800, 800),
                                new PictureSize(1600, 1600), new PictureSize(3840, 2160));
        for (PictureSize pixels : sizes) {
            parts.add(part("pixels", pixels.pixels(), pixels, "generated, 100 shapes, 4 lights, depth 2", throughput,
                    () -> GeneratedScenes.of(settings.seed(), pixels, SHAPES, LIGHTS, DEPTH)));
        }
        addCurve(parts, "lights", settings.quick() ? new int[] {1, 4, 16} : new int[] {1, 2, 4, 8, 16, 32, 64, 256, 1000}, throughput,
                "generated, 100 shapes, depth 2", n -> GeneratedScenes.of(settings.seed(), fixedSize, SHAPES, n, DEPTH));
        addCurve(parts, "shapes",
                settings.quick() ? new int[] {1, 10, 100, 1000} : new int[] {1, 10, 100, 1000, 10_000, 100_000, 1_000_000},
                throughput,
                "generated, 4 lights, depth 2", n -> GeneratedScenes.of(settings.seed(), fixedSize, n, LIGHTS, DEPTH));
        addCurve(parts, "depth", settings.quick() ? new int[] {0, 2, 4} : IntStream.rangeClosed(0, 10).toArray(), throughput,
                "generated, 100 shapes, 4 lights", n -> GeneratedScenes.of(settings.seed(), fixedSize, SHAPES, LIGHTS, n));
        return parts;
    }

    private void addCurve(List<BenchPart> parts, String along, int[] points, TraceThroughput throughput, String text,
            IntFunction<Scene> scene) {
        for (int n : points) {
            parts.add(part(along, n, fixedSize, text, throughput, () -> scene.apply(n)));
        }
    }

    private BenchPart part(String along, long at, PictureSize pixels, String text, TraceThroughput throughput, Supplier<Scene> scene) {
        String title = "growth with " + along + ", " + at;
        double timeFactor = switch (along) {
            case "lights" -> 0.5 + at / 4.0;
            case "shapes" -> 1 + at / 20_000.0;
            default -> 1;
        };
        return new BenchPart(title, timeFactor * throughput.updatesMs(pixels, settings.repetitions(), 15),
                progress -> ledger.addGrowth(along, text, point(along, at, title, scene.get(), progress.cancellationOnly())));
    }

    private GrowthPoint point(String along, long at, String title, Scene scene, Progress progress) {
        MemoryEstimate.check(scene, RenderOptions.DEFAULT.withThreads(settings.threads()));
        List<PaperCase> cases = PaperCases.of(scene).stream().filter(PaperCase::isPrinted).toList();
        try (UpdateSavingMeter meter =
                meter(RenderOptions.DEFAULT)) {
            List<UpdateSaving> savings = meter.updates(scene, cases.stream().map(PaperCase::after).toList(), progress);
            List<GrowthPoint.EditTime> edits = new ArrayList<>();
            for (int i = 0; i < savings.size(); i++) {
                add(edits, title, cases.get(i).name(), savings.get(i));
            }
            if (along.equals("depth")) {
                cases.stream().filter(edit -> edit.name().equals("position")).findFirst()
                        .ifPresent(edit -> add(edits, title, "mirrors updated after position", reflections(scene, edit, progress)));
            }
            return new GrowthPoint(at, TimeSamples.of(savings.getFirst().full()), edits);
        }
    }

    private UpdateSaving reflections(Scene scene, PaperCase edit, Progress progress) {
        try (UpdateSavingMeter meter = meter(RenderOptions.DEFAULT.withReflectionsOnRequest())) {
            return meter.reflections(scene, edit.after(), progress);
        }
    }

    private UpdateSavingMeter meter(RenderOptions options) {
        return new UpdateSavingMeter(options.withThreads(settings.threads()), settings.repetitions(), settings.patienceMs(), bytesPerMs);
    }

    private void add(List<GrowthPoint.EditTime> edits, String title, String name, UpdateSaving saving) {
        if (saving.isVerified()) {
            edits.add(new GrowthPoint.EditTime(name, TimeSamples.of(saving.time())));
        } else {
            ledger.addBroken(title + ", " + name, "the image differs from a full trace");
        }
    }
}
