package lightning.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.bench.result.EditingCost;
import lightning.bench.result.TimeSamples;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.JenWriter;
import lightning.render.RenderOptions;
import lightning.render.measure.InterleavedTimer;
import lightning.render.measure.Timing;
import lightning.render.relight.Renderer;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Benchmark of editing in generated scenes of up to a million shapes and a thousand lights, without window or rendering. Measures loading,
 * creating an edit's scene, planning, a hover and heap size.
 */
record EditingBench(BenchSettings settings, ResultCollector ledger) {
    private static final PictureSize SIZE = new PictureSize(64, 48);
    private static final int DEPTH = 2;
    /** Number of samples per repetition for sub-millisecond tasks, with as many for warm-up. */
    private static final int SHORT_SAMPLES = 8;
    /** Minimum number of shapes for heap measurements; smaller scenes are dominated by other objects. */
    private static final int MIN_HEAP_SHAPES = 10_000;
    /** Maximum number of shapes for repeated loading and BVH building; larger scenes are measured once. */
    private static final int MAX_REPEATED_SHAPES = 100_000;
    /** Predicted milliseconds per shape and load, and per light. */
    private static final double SHAPE_MS = 0.02;
    private static final double LIGHT_MS = 4;

    private record Point(int shapes, int lights) {}

    /** Returns the parts, one per scene. */
    List<BenchPart> parts() {
        List<Point> points = settings.quick() ? List.of(new Point(10, 10), new Point(1000, 100))
                : List.of(new Point(10, 10), new Point(10, 1000), new Point(100_000, 10), new Point(100_000, 1000),
                        new Point(1_000_000, 10), new Point(1_000_000, 1000));
        return points.stream().map(this::part).toList();
    }

    private BenchPart part(Point point) {
        String title = "editing " + point.shapes() + " shapes, " + point.lights() + " lights";
        double predictedMs = SHAPE_MS * point.shapes() * (1 + longSampleCount(point.shapes())) + LIGHT_MS * point.lights() + 500;
        return new BenchPart(title, predictedMs, progress -> ledger.addEditing(measure(point, progress)));
    }

    private int longSampleCount(int shapes) {
        return shapes > MAX_REPEATED_SHAPES ? 1 : settings.repetitions();
    }

    private EditingCost measure(Point point, Progress progress) {
        String text = JenWriter.write(GeneratedScenes.of(settings.seed(), SIZE, point.shapes(), point.lights(), DEPTH));
        int times = longSampleCount(point.shapes());
        TimeSamples load = samples(times, progress, _ -> InterleavedTimer.timeMs(() -> read(text)));
        boolean measuresHeap = point.shapes() >= MIN_HEAP_SHAPES;
        long emptyBytes = measuresHeap ? usedHeapBytes() : 0;
        Scene scene = read(text).scene();
        long documentBytes = measuresHeap ? usedHeapBytes() : 0;
        TimeSamples tree = samples(times, progress, _ -> InterleavedTimer.timeMs(() -> Geometry.of(scene)));
        long beforeTreeBytes = measuresHeap ? usedHeapBytes() : 0;
        Geometry geometry = Geometry.of(scene);
        long treeBytes = measuresHeap ? usedHeapBytes() : 0;
        Light first = scene.lights().getFirst();
        TimeSamples newScene = shortSamples(progress, i -> InterleavedTimer.timeMs(() -> scene.withLight(first.withIntensity(2 + i))));
        var explainer = new PixelExplainer(scene, geometry);
        explainer.explainPixel(SIZE.width() / 2, SIZE.height() / 2);
        TimeSamples hover = shortSamples(progress, i -> {
            Scene moved = scene.withLight(first.withPosition(first.position().plus(new Vec3(0.01 * (i + 1), 0, 0))));
            return InterleavedTimer.timeMs(() -> explainer.forScene(moved, geometry).explainPixel(SIZE.width() / 2, SIZE.height() / 2));
        });
        return new EditingCost(point.shapes(), point.lights(), load, tree, newScene, plan(scene, geometry, progress), hover,
                measuresHeap ? (double) (documentBytes - emptyBytes) / point.shapes() : Double.NaN,
                measuresHeap ? (double) (treeBytes - beforeTreeBytes) / point.shapes() : Double.NaN);
    }

    private TimeSamples plan(Scene scene, Geometry geometry, Progress progress) {
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withThreads(settings.threads()))) {
            renderer.setSharedGeometry(geometry);
            renderer.render(scene, progress.cancellationOnly());
            Light first = scene.lights().getFirst();
            return shortSamples(progress, i -> {
                Scene edited = scene.withLight(first.withIntensity(2 + i));
                return InterleavedTimer.timeMs(() -> renderer.plan(edited));
            });
        }
    }

    private TimeSamples shortSamples(Progress progress, IntFunction<Double> sample) {
        int times = SHORT_SAMPLES * settings.repetitions();
        if (settings.isWarm()) {
            samples(times, progress, i -> sample.apply(times + i));
        }
        return samples(times, progress, sample);
    }

    private static TimeSamples samples(int times, Progress progress, IntFunction<Double> sample) {
        List<Double> ms = new ArrayList<>();
        for (int i = 0; i < times; i++) {
            progress.checkCanceled("canceled after " + i + " of " + times + " samples");
            ms.add(sample.apply(i));
        }
        return TimeSamples.of(new Timing(ms));
    }

    private static JenDocument read(String text) {
        try {
            return JenReader.read(text, "generated", Path.of(""));
        } catch (JenException e) {
            throw new IllegalStateException("a written scene cannot be read", e);
        }
    }

    /** Returns the bytes of heap in use after garbage collection. */
    private static long usedHeapBytes() {
        // The second run frees objects that the first found finalizable or softly reachable.
        System.gc();
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
