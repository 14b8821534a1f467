import com.sun.management.ThreadMXBean;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.scene.Attenuation;
import lightning.scene.Light;
import lightning.scene.LightType;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Times one build of the engine by the names that all builds share, for {@code benchmarks/pair}: a line for each of the full
 * trace, the first pass and some edits, with the median time in milliseconds, the median of the processor time of all threads in
 * milliseconds, the median of the bytes that they allocate, and two counts that no machine changes: rows and bytes kept, or rows
 * touched and shadow rays.
 */
final class Pair {
    private static final int TIMES = 25;
    /** Fewer of both where they take longer than this, but no fewer than some. */
    private static final long MOST_NANOSECONDS = 700_000_000L;
    private static final int LEAST = 5;
    /**
     * Warm is what Java's compilers rest beside: they worked less than {@link #REST} of a window of so many nanoseconds. Warming up ends
     * after so many windows in any case. What compiles most comes first, in longer windows: a single method may take a second.
     */
    private static final long WINDOW = 400_000_000L;
    private static final long FIRST_WINDOW = 2_000_000_000L;
    private static final int MOST_WINDOWS = 10;
    private static final double REST = 0.05;
    private static final int MOST_TIMES = 10_000;
    private static final int THREADS = 2;
    private static final CompilationMXBean COMPILERS = ManagementFactory.getCompilationMXBean();
    private static final ThreadMXBean ALL = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** What each of some runs took: milliseconds, those of processors, bytes. */
    private record Taken(double[] times, double[] processor, double[] bytes) {}

    public static void main(String[] args) throws Exception {
        Engines.use(Engines.FASTEST);
        Scene read = JenReader.read(Path.of(args[0])).scene();
        Scene scene = read.withPicture(new PictureSettings(1920, 1080, read.picture().depth()));
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(THREADS));
                var workers = new WorkerPool(THREADS)) {
            var geometry = new Geometry(scene);
            print("full-trace",
                    times(FIRST_WINDOW, () -> {}, () -> new TraditionalTracer(scene, geometry).trace(workers, Progress.NONE)),
                    0, 0);
            Taken first = times(FIRST_WINDOW, renderer::clear, () -> renderer.render(scene, Progress.NONE));
            print("first-pass", first, renderer.cache().rowCount(), renderer.cache().bytes());
            for (Map.Entry<String, Scene> edit : edits(scene).entrySet()) {
                var update = new UpdateResult[1];
                Taken times = times(WINDOW, () -> renderer.render(scene, Progress.NONE),
                        () -> update[0] = renderer.render(edit.getValue(), Progress.NONE));
                print(edit.getKey(), times, update[0].rowsTouched(), update[0].rays().shadow());
            }
        }
    }

    private static Taken times(long window, Runnable before, Runnable timed) {
        long worked = Long.MAX_VALUE;
        for (int i = 0; i < MOST_WINDOWS && worked > REST * window; i++) {
            long compiled = COMPILERS.getTotalCompilationTime();
            take(MOST_TIMES, window, before, timed);
            worked = (COMPILERS.getTotalCompilationTime() - compiled) * 1_000_000;
        }
        return take(TIMES, MOST_NANOSECONDS, before, timed);
    }

    private static Taken take(int most, long nanoseconds, Runnable before, Runnable timed) {
        double[][] taken = new double[3][most];
        int count = 0;
        long begin = System.nanoTime();
        while (count < most && (count < LEAST || System.nanoTime() - begin < nanoseconds)) {
            before.run();
            long[] ids = ALL.getAllThreadIds();
            long processor = sum(ALL.getThreadCpuTime(ids));
            long bytes = sum(ALL.getThreadAllocatedBytes(ids));
            long start = System.nanoTime();
            timed.run();
            taken[0][count] = (System.nanoTime() - start) / 1e6;
            taken[1][count] = (sum(ALL.getThreadCpuTime(ids)) - processor) / 1e6;
            taken[2][count++] = sum(ALL.getThreadAllocatedBytes(ids)) - bytes;
        }
        return new Taken(Arrays.copyOf(taken[0], count), Arrays.copyOf(taken[1], count), Arrays.copyOf(taken[2], count));
    }

    /** Those of threads that have ended are −1. */
    private static long sum(long[] ofThreads) {
        return Arrays.stream(ofThreads).filter(v -> v > 0).sum();
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        return values[values.length / 2];
    }

    private static void print(String name, Taken taken, long one, long other) {
        System.out.printf(Locale.ROOT, "%s %.4f %.4f %.0f %d %d%n", name, median(taken.times), median(taken.processor),
                median(taken.bytes), one, other);
    }

    private static Map<String, Scene> edits(Scene scene) {
        Map<String, Scene> edits = new LinkedHashMap<>();
        edits.put("ambience", scene.withWorld(scene.world().withAmbience(0.5)));
        for (LightType type : LightType.values()) {
            scene.lights().stream().filter(l -> l.type() == type).findFirst().ifPresent(l -> {
                String kind = type.name().toLowerCase(Locale.ROOT);
                edits.put(kind + "-intensity", scene.withLight(l.withIntensity(l.intensity() * 0.7)));
                edits.put(kind + "-deleted", without(scene, l));
                if (type.hasPosition()) {
                    edits.put(kind + "-attenuation", scene.withLight(l.withAttenuation(new Attenuation(0.7, 0.1, 0.01))));
                    edits.put(kind + "-moved", scene.withLight(l.withPosition(l.position().plus(new Vec3(0.2, 0.1, 0.1)))));
                }
                if (type.hasCone()) {
                    edits.put(kind + "-narrower", scene.withLight(l.withAngle(l.angle() * 0.8)));
                    edits.put(kind + "-wider", scene.withLight(l.withAngle(l.angle() * 1.2)));
                    edits.put(kind + "-dropoff", scene.withLight(l.withDropoff(l.dropoff() + 3)));
                }
                if (!type.hasPosition()) {
                    edits.put(kind + "-turned", scene.withLight(l.withDirection(l.direction().plus(new Vec3(0.1, 0, 0.1)))));
                }
            });
        }
        return edits;
    }

    private static Scene without(Scene scene, Light light) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.remove(light);
        return scene.withLights(lights);
    }
}
