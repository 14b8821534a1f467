import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.MemoryBandwidth;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.ReflectionMode;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;

/**
 * Compares edits with the memory limit, for {@code benchmarks/floor}: the processor time of one thread, and the time that its memory
 * needs for the bytes that the edit reads and writes.
 */
final class Floor {
    private static final double WARM_UP_MS = 1500;
    private static final double MEASURED_MS = 1000;
    private static final int MIN_SAMPLES = 7;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    public static void main(String[] args) throws Exception {
        Engines.use(Engines.FASTEST);
        Scene read = JenReader.read(Path.of(args[0])).scene();
        Scene scene = read.withPicture(new PictureSettings(Integer.parseInt(args[1]), Integer.parseInt(args[2]), read.picture().depth()));
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1));
                var worker = new WorkerPool(1)) {
            double bytesPerMs = MemoryBandwidth.triad(worker, 15).stream().mapToDouble(d -> d).max().orElseThrow();
            System.out.printf(Locale.ROOT, "%s at %sx%s; memory: %.1f GB/s%n%-20s %9s %9s %9s %9s%n", Path.of(args[0]).getFileName(),
                    args[1],
                    args[2], bytesPerMs / 1e6, "edit", "floor, ms", "takes, ms", "times", "saves, %");
            TraditionalTracer tracer = new TraditionalTracer(scene);
            double full = median(() -> {}, () -> tracer.trace(worker, Progress.NONE));
            for (PaperCase edit : PaperCases.of(scene)) {
                List<Scene> scenes = edit.scenes();
                renderer.render(scenes.get(scenes.size() - 2), Progress.NONE);
                PixelCache cacheBefore = renderer.cache();
                UpdateResult[] update = new UpdateResult[1];
                double ms = median(() -> renderer.restore(cacheBefore), () -> update[0] = renderer.render(edit.after(), Progress.NONE));
                double floor = update[0].bytesMoved() / bytesPerMs;
                System.out.printf(Locale.ROOT, "%-20s %9.3f %9.3f %9.2f %9.1f%n", edit.name(), floor, ms, ms / floor,
                        100 * (1 - ms / full));
            }
        }
    }

    private static double median(Runnable before, Runnable timed) {
        sample(before, timed, WARM_UP_MS);
        double[] times = sample(before, timed, MEASURED_MS);
        return times[times.length / 2];
    }

    /** Repeats the timed work for at least this time and returns its processor times in milliseconds, sorted. */
    private static double[] sample(Runnable before, Runnable timed, double milliseconds) {
        double[] times = new double[0];
        for (double sum = 0; sum < milliseconds || times.length < MIN_SAMPLES; sum += times[times.length - 1]) {
            before.run();
            long start = THREADS.getCurrentThreadCpuTime();
            timed.run();
            times = Arrays.copyOf(times, times.length + 1);
            times[times.length - 1] = Math.max((THREADS.getCurrentThreadCpuTime() - start) / 1e6, 1e-3);
        }
        Arrays.sort(times);
        return times;
    }
}
