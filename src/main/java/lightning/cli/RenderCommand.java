package lightning.cli;

import java.util.concurrent.Callable;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrType;
import lightning.format.image.ImageFormat;
import lightning.format.layer.ExrContent;
import lightning.format.layer.LayeredExrWriter;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.TraceMemory;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.RayCounts;
import lightning.render.warmup.DelayedWarmUp;
import lightning.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Traces a scene and writes the image. */
@Command(name = "render", abbreviateSynopsis = true, header = "Render a scene to an image file.",
        description = "Traces the scene and prints the time and the number of rays.",
        footer = {
            "Examples:",
            "  lightning render scenes/bird.jen -o bird.png",
            "  lightning render scenes/bird.jen -o big.png --size 1920x1080 --exposure 0.5",
            "  lightning render scenes/bird.jen -o layers.exr --layers --bits 32",
            "  lightning render scenes/bird.jen -o exact.pfm --depth 0 --traditional"})
final class RenderCommand implements Callable<Integer> {
    private final Console console;

    @Spec
    private CommandSpec command;
    @Mixin
    private SceneFile input;
    @Mixin
    private SinglePictureOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--traditional",
            description = "Trace without a cache for later edits; the image is the same. Prints a cold timing, not a benchmark: "
                    + "bench and relight warm up first.")
    private boolean traditional;

    @Option(names = "--layers",
            description = "Also write layers to the .exr: background, ambient, emission, each light's diffuse and specular, reflections "
                    + "(which add up to the image), normals, positions, depth, objects and materials.")
    private boolean layers;

    RenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        output.check();
        if (layers && !ImageFormat.of(output.file()).canHaveLayers()) {
            throw new BadInputException(Console.text("%s: layers are written to .exr", output.file()));
        }
        if (layers && traditional) {
            throw new BadInputException("--layers and --traditional cannot be combined: a trace without a cache has no layers");
        }
        Scene scene = picture.apply(input.read().scene());
        console.printWarnings(input.path(), scene);
        LongRenderRestart.restartIfLong(scene, command.root().commandLine().getParseResult().originalArgs());
        if (traditional) {
            traceTraditionally(scene);
        } else {
            firstPass(scene);
        }
        return ExitCode.OK;
    }

    private void traceTraditionally(Scene scene) throws Exception {
        TraceMemory.check(scene, output.availableMemory(scene));
        try (var _ = new DelayedWarmUp(scene); WorkerPool workers = new WorkerPool(threads.count());
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            long start = System.nanoTime();
            TraditionalTracer.Result result = new TraditionalTracer(scene).trace(workers, bar);
            write(scene, result.film(), "traditional trace", (System.nanoTime() - start) / 1e6, result.rays());
        }
    }

    private void firstPass(Scene scene) throws Exception {
        try (var _ = new DelayedWarmUp(scene);
                Renderer renderer =
                        new Renderer(RenderOptions.DEFAULT.withThreads(threads.count()).withMemory(output.availableMemory(scene)));
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            var update = renderer.render(scene, bar);
            if (layers) {
                long start = System.nanoTime();
                LayeredExrWriter file = new LayeredExrWriter(renderer.cache(), renderer.options().engines(), ExrContent.layers(
                        output.bits() == Short.SIZE ? ExrType.HALF : ExrType.FLOAT), java.util.Optional.empty());
                try (WorkerPool workers = new WorkerPool(threads.count()); ProgressBar writing = new ProgressBar(console, "writing")) {
                    file.write(output.file(), renderer.options().memory() - renderer.bytes(), workers, writing);
                }
                console.print("%s: %s of %d x %d pixels, written in %.1f ms", output.file(), Console.count(file.layerCount(), "layer"),
                        scene.picture().width(),
                        scene.picture().height(), (System.nanoTime() - start) / 1e6);
                printSummary(scene, renderer.film(), "first pass", update.milliseconds(), update.rays());
                return;
            }
            write(scene, renderer.film(), "first pass", update.milliseconds(), update.rays());
        }
    }

    private void write(Scene scene, Film film, String title, double milliseconds, RayCounts rays) throws Exception {
        output.write(scene, film, threads.count(), console);
        printSummary(scene, film, title, milliseconds, rays);
    }

    private void printSummary(Scene scene, Film film, String title, double milliseconds, RayCounts rays) {
        console.print("%s: %s of %d x %d pixels, depth %d, in %.1f ms%s: %s, %d mirrored, %s%s", output.file(), title,
                film.width(), film.height(), scene.picture().depth(), milliseconds, Engines.isFastestInUse() ? "" : " (cold start)",
                Console.count(rays.eye(), "eye ray"),
                rays.mirrored(), rays.gather() == 0 ? "" : Console.count(rays.gather(), "gather ray") + ", ",
                Console.count(rays.shadow(), "shadow ray"));
    }
}
