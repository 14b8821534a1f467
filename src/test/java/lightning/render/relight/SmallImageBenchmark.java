package lightning.render.relight;

import com.sun.management.ThreadMXBean;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import lightning.base.work.Progress;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;

/**
 * Benchmark of every edit in a small picture after warm-up, in repeated blocks. Reports for each edit the minimum and median of
 * wall-clock time and of the CPU time of all threads, in milliseconds, and the kilobytes allocated.
 */
final class SmallImageBenchmark {
    private static final int RUNS_IN_SEQUENCE = 12;
    private static final double WINDOW_SECONDS = 1;
    /** Maximum CPU share of the JIT compilers in an idle window. */
    private static final double IDLE_SHARE = 0.05;
    private static final CompilationMXBean COMPILERS = ManagementFactory.getCompilationMXBean();
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private SmallImageBenchmark() {}

    /** @param args width, height, threads, maximum seconds of warm-up, seconds of measurement, scenes; scene:edit,edit selects edits */
    public static void main(String[] args) throws Exception {
        for (String arg : Arrays.asList(args).subList(5, args.length)) {
            String[] parts = arg.split(":");
            Scene read = JenReader.read(Path.of(parts[0])).scene();
            Scene scene = read.withPicture(read.picture().withSize(Integer.parseInt(args[0]), Integer.parseInt(args[1])));
            List<PaperCase> cases = PaperCases.of(scene).stream()
                    .filter(c -> parts.length == 1 || List.of(parts[1].split(",")).contains(c.name())).toList();
            System.out.printf(Locale.ROOT, "%s%n%-16s %8s %8s %8s %8s %8s%n", Path.of(parts[0]).getFileName(), "edit", "least", "median",
                    "least cpu", "cpu", "kB");
            try (Renderer renderer =
                    new Renderer(RenderOptions.DEFAULT.withThreads(Integer.parseInt(args[2])).withEngines(Engines.FASTEST))) {
                PixelCache[] starts = new PixelCache[cases.size()];
                renderer.render(scene, Progress.NONE);
                PixelCache first = renderer.cache();
                for (int c = 0; c < starts.length; c++) {
                    renderer.restore(first);
                    List<Scene> scenes = cases.get(c).scenes();
                    renderer.render(scenes.get(scenes.size() - 2), Progress.NONE);
                    starts[c] = renderer.cache();
                }
                warmUp(renderer, cases, starts, Double.parseDouble(args[3]));
                double[][][] measured = measure(renderer, cases, starts, Double.parseDouble(args[4]));
                for (int c = 0; c < starts.length; c++) {
                    double[][] of = measured[c];
                    System.out.printf(Locale.ROOT, "%-16s %8.2f %8.2f %8.2f %8.2f %8.0f%n", cases.get(c).name(), of[0][0],
                            median(of[0]), of[1][0], median(of[1]), median(of[2]));
                }
            }
        }
    }

    /** Runs until Java's compilers are idle, or for the maximum time. */
    private static void warmUp(Renderer renderer, List<PaperCase> cases, PixelCache[] starts, double maxSeconds) {
        long begin = System.nanoTime();
        long worked = Long.MAX_VALUE;
        long window = 0;
        while (worked > IDLE_SHARE * window && System.nanoTime() - begin < maxSeconds * 1e9) {
            long from = System.nanoTime();
            long compiled = COMPILERS.getTotalCompilationTime();
            measure(renderer, cases, starts, WINDOW_SECONDS);
            worked = (COMPILERS.getTotalCompilationTime() - compiled) * 1_000_000;
            window = System.nanoTime() - from;
        }
    }

    /** Returns for each case the sorted times, CPU times and kilobytes. */
    private static double[][][] measure(Renderer renderer, List<PaperCase> cases, PixelCache[] starts, double seconds) {
        double[][][] measured = new double[starts.length][3][0];
        long begin = System.nanoTime();
        do {
            for (int c = 0; c < starts.length; c++) {
                for (int i = 0; i < RUNS_IN_SEQUENCE; i++) {
                    renderer.restore(starts[c]);
                    double[] now = measureOnce(renderer, cases.get(c).after());
                    for (int v = 0; v < now.length; v++) {
                        measured[c][v] = Arrays.copyOf(measured[c][v], measured[c][v].length + 1);
                        measured[c][v][measured[c][v].length - 1] = now[v];
                    }
                }
            }
        } while (System.nanoTime() - begin < seconds * 1e9);
        for (double[][] of : measured) {
            Arrays.stream(of).forEach(Arrays::sort);
        }
        return measured;
    }

    private static double[] measureOnce(Renderer renderer, Scene after) {
        long[] ids = THREADS.getAllThreadIds();
        long bytes = sum(THREADS.getThreadAllocatedBytes(ids));
        long processor = sum(THREADS.getThreadCpuTime(ids));
        long start = System.nanoTime();
        renderer.render(after, Progress.NONE);
        return new double[] {(System.nanoTime() - start) / 1e6, (sum(THREADS.getThreadCpuTime(ids)) - processor) / 1e6,
            (sum(THREADS.getThreadAllocatedBytes(ids)) - bytes) / 1e3};
    }

    private static double median(double[] sorted) {
        return sorted[sorted.length / 2];
    }

    /** Ignores threads that have ended, which report −1. */
    private static long sum(long[] ofThreads) {
        return Arrays.stream(ofThreads).filter(v -> v > 0).sum();
    }
}
