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
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.Attenuation;

/**
 * Times one build of the engine, for {@code benchmarks/pair}, with names that all builds share. Prints a line for the full trace, the
 * first pass and each edit: the medians of the elapsed milliseconds, the processor milliseconds of all threads and the bytes that they
 * allocate. Two counts follow that do not depend on the machine: rows and bytes cached, or rows touched and shadow rays.
 */
final class Pair {
    private static final int MAX_SAMPLES = 25;
    /** Time after which sampling stops, once there are {@link #MIN_SAMPLES}. */
    private static final long MAX_NANOSECONDS = 700_000_000L;
    private static final int MIN_SAMPLES = 5;
    /**
     * Length of a warm-up window, nanoseconds. Warm-up ends when Java's compilers work for less than {@link #WARM_SHARE} of a window, or
     * after {@link #MAX_WINDOWS}. The full trace and the first pass compile most: they have longer windows, because
     * a single method can need a second.
     */
    private static final long WINDOW = 400_000_000L;
    private static final long FIRST_WINDOW = 2_000_000_000L;
    private static final int MAX_WINDOWS = 10;
    private static final double WARM_SHARE = 0.05;
    private static final int MAX_WARM_UPS = 10_000;
    private static final int THREADS = 2;
    private static final CompilationMXBean COMPILERS = ManagementFactory.getCompilationMXBean();
    private static final ThreadMXBean ALL = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /** Costs of each run: elapsed milliseconds, processor milliseconds, allocated bytes. */
    private record Samples(double[] times, double[] processor, double[] bytes) {}

    public static void main(String[] args) throws Exception {
        Engines.use(Engines.FASTEST);
        Scene read = JenReader.read(Path.of(args[0])).scene();
        Scene scene = read.withPicture(new PictureSettings(1920, 1080, read.picture().depth()));
        try (var renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(THREADS));
                var preparing = new Renderer(RenderOptions.DEFAULT.withThreads(THREADS)); var workers = new WorkerPool(THREADS)) {
            // By a renderer, because builds differ in how geometry is made.
            Geometry geometry = preparing.prepare(scene);
            print("full-trace",
                    times(FIRST_WINDOW, () -> {}, () -> new TraditionalTracer(scene, geometry).trace(workers, Progress.NONE)),
                    0, 0);
            Samples first = times(FIRST_WINDOW, renderer::clear, () -> renderer.render(scene, Progress.NONE));
            print("first-pass", first, renderer.cache().rowCount(), renderer.cache().bytes());
            for (Map.Entry<String, Scene> edit : edits(scene).entrySet()) {
                var update = new UpdateResult[1];
                Samples times = times(WINDOW, () -> renderer.render(scene, Progress.NONE),
                        () -> update[0] = renderer.render(edit.getValue(), Progress.NONE));
                print(edit.getKey(), times, update[0].rowsTouched(), update[0].rays().shadow());
            }
        }
    }

    private static Samples times(long window, Runnable before, Runnable timed) {
        long compilerTime = Long.MAX_VALUE;
        for (int i = 0; i < MAX_WINDOWS && compilerTime > WARM_SHARE * window; i++) {
            long compiled = COMPILERS.getTotalCompilationTime();
            sample(MAX_WARM_UPS, window, before, timed);
            compilerTime = (COMPILERS.getTotalCompilationTime() - compiled) * 1_000_000;
        }
        return sample(MAX_SAMPLES, MAX_NANOSECONDS, before, timed);
    }

    private static Samples sample(int most, long nanoseconds, Runnable before, Runnable timed) {
        double[][] samples = new double[3][most];
        int count = 0;
        long begin = System.nanoTime();
        while (count < most && (count < MIN_SAMPLES || System.nanoTime() - begin < nanoseconds)) {
            before.run();
            long[] ids = ALL.getAllThreadIds();
            long processor = sum(ALL.getThreadCpuTime(ids));
            long bytes = sum(ALL.getThreadAllocatedBytes(ids));
            long start = System.nanoTime();
            timed.run();
            samples[0][count] = (System.nanoTime() - start) / 1e6;
            samples[1][count] = (sum(ALL.getThreadCpuTime(ids)) - processor) / 1e6;
            samples[2][count++] = sum(ALL.getThreadAllocatedBytes(ids)) - bytes;
        }
        return new Samples(Arrays.copyOf(samples[0], count), Arrays.copyOf(samples[1], count), Arrays.copyOf(samples[2], count));
    }

    /** Sums the values of all threads; ended threads have −1, which does not count. */
    private static long sum(long[] ofThreads) {
        return Arrays.stream(ofThreads).filter(v -> v > 0).sum();
    }

    private static double median(double[] values) {
        Arrays.sort(values);
        return values[values.length / 2];
    }

    private static void print(String name, Samples samples, long one, long other) {
        System.out.printf(Locale.ROOT, "%s %.4f %.4f %.0f %d %d%n", name, median(samples.times), median(samples.processor),
                median(samples.bytes), one, other);
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
