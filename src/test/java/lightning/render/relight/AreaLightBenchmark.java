package lightning.render.relight;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;

/**
 * Benchmark of area light edits against full traces of the same scene, interleaved: medians of wall-clock and CPU milliseconds.
 * {@code java … lightning.render.relight.AreaLightBenchmark scenes/bird.jen lamp 1920 1080 16 15}.
 */
final class AreaLightBenchmark {
    private static final OperatingSystemMXBean PROCESS = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private AreaLightBenchmark() {}

    /** @param args scene, light, width, height, samples (0 for a point), rounds */
    public static void main(String[] args) throws Exception {
        int samples = Integer.parseInt(args[4]);
        int rounds = Integer.parseInt(args[5]);
        Scene read = JenReader.read(Path.of(args[0])).scene();
        Light light = read.light(args[1]).orElseThrow();
        Light large = samples == 0 ? light : light.withArea(new AreaShape(0.3, 2, 1, 1, Vec3.Y, samples));
        Scene scene = read.withLight(large)
                .withPicture(read.picture().withSize(Integer.parseInt(args[2]), Integer.parseInt(args[3])));
        Scene[] edits = {scene.withLight(large.withPosition(large.position().plus(new Vec3(0.1, 0, 0)))
                .withDirection(large.direction().plus(new Vec3(0.01, 0, 0)))),
            scene.withLight(large.withIntensity(large.intensity() / 2)),
            scene.withLight(large.withAttenuation(new lightning.scene.value.Attenuation(0.2, 0.5, 0.1)))};
        String[] names = {"moved", "weight", "falloff", "full trace"};
        double[][] wall = new double[4][rounds];
        double[][] cpu = new double[4][rounds];
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(2).withEngines(Engines.FASTEST));
                WorkerPool workers = new WorkerPool(2)) {
            renderer.render(scene, Progress.NONE);
            var start = renderer.cache();
            for (int r = -rounds / 2; r < rounds; r++) {
                for (int e = 0; e < 4; e++) {
                    long c = PROCESS.getProcessCpuTime();
                    long t = System.nanoTime();
                    if (e < 3) {
                        renderer.restore(start);
                        renderer.render(edits[e], Progress.NONE);
                    } else {
                        new TraditionalTracer(edits[0], start.geometry()).withEngines(Engines.FASTEST).trace(workers, Progress.NONE);
                    }
                    if (r >= 0) {
                        wall[e][r] = (System.nanoTime() - t) / 1e6;
                        cpu[e][r] = (PROCESS.getProcessCpuTime() - c) / 1e6;
                    }
                }
            }
        }
        for (int e = 0; e < 4; e++) {
            System.out.printf(Locale.ROOT, "%-10s wall %7.1f  processor %7.1f%n", names[e], median(wall[e]), median(cpu[e]));
        }
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
