package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.bench.accuracy.Saving;
import lightning.bench.accuracy.SavingMeter;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** Measures how the times of edits grow with pixels, lights, shapes and mirror bounces, on generated scenes. */
final class GrowthBench {
    private static final int SHAPES = 100;
    private static final int LIGHTS = 4;
    private static final int DEPTH = 2;

    private final Settings settings;
    private final Ledger ledger;
    private final double bytesPerMs;
    /** The size of pictures while something else grows. */
    private final PictureSize size;

    GrowthBench(Settings settings, Ledger ledger, double bytesPerMs) {
        this.settings = settings;
        this.ledger = ledger;
        this.bytesPerMs = bytesPerMs;
        // Tests that ask for no times set a small one.
        int side = Integer.getInteger("lightning.growth", 300);
        size = new PictureSize(side, side);
    }

    /** What is to be measured: a part for each point of each curve. */
    List<Part> parts(Pace pace) {
        List<Part> parts = new ArrayList<>();
        List<PictureSize> sizes =
                settings.quick() ? List.of(new PictureSize(100, 100), new PictureSize(200, 200), new PictureSize(400, 400))
                        : List.of(new PictureSize(100, 100), new PictureSize(200, 200), new PictureSize(400, 400),
                                new PictureSize(800, 800),
                                new PictureSize(1600, 1600), new PictureSize(3840, 2160));
        for (PictureSize pixels : sizes) {
            parts.add(part("pixels", pixels.pixels(), pixels, "generated, 100 shapes, 4 lights, depth 2", pace,
                    () -> GeneratedScenes.of(settings.seed(), pixels, SHAPES, LIGHTS, DEPTH)));
        }
        curve(parts, "lights", settings.quick() ? new int[] {1, 4, 16} : new int[] {1, 2, 4, 8, 16, 32, 64, 256, 1000}, pace,
                "generated, 100 shapes, depth 2", n -> GeneratedScenes.of(settings.seed(), size, SHAPES, n, DEPTH));
        curve(parts, "shapes", settings.quick() ? new int[] {1, 10, 100, 1000} : new int[] {1, 10, 100, 1000, 10_000, 100_000, 1_000_000},
                pace,
                "generated, 4 lights, depth 2", n -> GeneratedScenes.of(settings.seed(), size, n, LIGHTS, DEPTH));
        curve(parts, "depth", settings.quick() ? new int[] {0, 2, 4} : IntStream.rangeClosed(0, 10).toArray(), pace,
                "generated, 100 shapes, 4 lights", n -> GeneratedScenes.of(settings.seed(), size, SHAPES, LIGHTS, n));
        return parts;
    }

    private void curve(List<Part> parts, String along, int[] points, Pace pace, String text, IntFunction<Scene> scene) {
        for (int n : points) {
            parts.add(part(along, n, size, text, pace, () -> scene.apply(n)));
        }
    }

    private Part part(String along, long at, PictureSize pixels, String text, Pace pace, Supplier<Scene> scene) {
        String where = "growth with " + along + ", " + at;
        double generous = switch (along) {
            case "lights" -> 0.5 + at / 4.0;
            case "shapes" -> 1 + at / 20_000.0;
            default -> 1;
        };
        return new Part(where, generous * pace.updatesMs(pixels, settings.repetitions(), 15),
                progress -> ledger.growth(along, text, point(along, at, where, scene.get(), progress.silent())));
    }

    private GrowthPoint point(String along, long at, String where, Scene scene, Progress progress) {
        MemoryNeed.check(scene, Options.DEFAULT.withThreads(settings.threads()));
        List<PaperCase> cases = PaperCases.of(scene).stream().filter(PaperCase::isPrinted).toList();
        try (SavingMeter meter =
                meter(Options.DEFAULT)) {
            List<Saving> savings = meter.updates(scene, cases.stream().map(PaperCase::after).toList(), progress);
            List<GrowthPoint.EditTime> edits = new ArrayList<>();
            for (int i = 0; i < savings.size(); i++) {
                add(edits, where, cases.get(i).name(), savings.get(i));
            }
            if (along.equals("depth")) {
                cases.stream().filter(edit -> edit.name().equals("position")).findFirst()
                        .ifPresent(edit -> add(edits, where, "mirrors updated after position", reflections(scene, edit, progress)));
            }
            return new GrowthPoint(at, Samples.of(savings.getFirst().full()), edits);
        }
    }

    private Saving reflections(Scene scene, PaperCase edit, Progress progress) {
        try (SavingMeter meter = meter(Options.DEFAULT.withReflections(Reflections.STALE))) {
            return meter.reflections(scene, edit.after(), progress);
        }
    }

    private SavingMeter meter(Options options) {
        return new SavingMeter(options.withThreads(settings.threads()), settings.repetitions(), settings.patienceMs(), bytesPerMs);
    }

    private void add(List<GrowthPoint.EditTime> edits, String where, String name, Saving saving) {
        if (saving.kept()) {
            edits.add(new GrowthPoint.EditTime(name, Samples.of(saving.time())));
        } else {
            ledger.problem(new Failure(Failure.Kind.BROKEN, where + ", " + name, "the picture is not that of a full trace"));
        }
    }
}
