package lightning.cli;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.Callable;
import lightning.base.work.WorkerPool;
import lightning.cli.option.LayerOptions;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ResidentOption;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.SinglePictureOutput;
import lightning.cli.report.RaysReport;
import lightning.cli.report.RenderReport;
import lightning.format.jen.InputFiles;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Clipping;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.TraceMemory;
import lightning.render.shading.RayCounts;
import lightning.render.warmup.DelayedLanes;
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
            "  lightning render scenes/bird.jen -o bird.png --cryptomatte mattes.exr",
            "  lightning render scenes/bird.jen -o exact.pfm --depth 0 --traditional"})
final class RenderCommand implements Callable<Integer> {
    private final Console console;
    private final KeptRenderer kept;

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
    @Mixin
    private LayerOptions layers;
    @Mixin
    private ResidentOption resident;
    @Option(names = "--traditional",
            description = "Trace without a cache for later edits; the image is the same. Prints a cold timing, not a benchmark: "
                    + "bench and relight warm up first.")
    private boolean traditional;

    RenderCommand(Console console, KeptRenderer kept) {
        this.console = console;
        this.kept = kept;
    }

    @Override
    public Integer call() throws Exception {
        output.check();
        layers.checkFormats(output, output.file());
        if (layers.mattes().isPresent()) {
            PictureOutput.checkFile(layers.mattes().get());
        }
        if (traditional && layers.usedOption().isPresent()) {
            throw new BadInputException(layers.usedOption().get() + " and --traditional cannot be combined: a trace without a cache has no "
                    + layers.requiredContent());
        }
        Scene scene = picture.apply(input.read(console).scene());
        layers.checkSize(scene.picture());
        InputFiles inputs = output.withViewFile(input.inputs(scene));
        output.printViewNotes(console);
        inputs.check(output.file());
        if (layers.mattes().isPresent()) {
            inputs.check(layers.mattes().get());
        }
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
        kept.close();
        TraceMemory.check(scene, output.availableMemory(scene));
        try (var _ = new DelayedLanes(); WorkerPool workers = new WorkerPool(threads.count());
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            long start = System.nanoTime();
            TraditionalTracer.Result result = new TraditionalTracer(scene).trace(workers, bar);
            output.write(scene, result.film(), output.file(), Optional.empty(), workers);
            printSummary(scene, result.film(), "traditional trace", (System.nanoTime() - start) / 1e6, result.rays());
        }
    }

    private void firstPass(Scene scene) throws Exception {
        Renderer renderer = kept.with(RenderOptions.DEFAULT.withThreads(threads.count()).withMemory(output.availableMemory(scene)));
        try (var _ = new DelayedLanes(); ProgressBar bar = new ProgressBar(console, "tracing")) {
            var update = renderer.renderOrClear(scene, bar);
            try (WorkerPool workers = new WorkerPool(threads.count())) {
                layers.write(output, renderer.cache(), renderer.options().engines(), Optional.of(output.file()), layers.mattes(),
                        Optional.empty(), workers, console);
            }
            printSummary(scene, renderer.film(), KeptRenderer.title(update), update.milliseconds(), update.rays());
        }
    }

    private void printSummary(Scene scene, Film film, String title, double milliseconds, RayCounts rays) throws IOException {
        output.printClipping(scene, film, output.file(), console);
        console.print("%s: %s of %d x %d pixels, depth %d, in %.1f ms%s: %s, %d mirrored, %s%s", output.file(), title,
                film.width(), film.height(), scene.picture().depth(), milliseconds, Engines.isFastestInUse() ? "" : " (cold start)",
                Console.count(rays.eye(), "eye ray"),
                rays.mirrored(), rays.gather() == 0 ? "" : Console.count(rays.gather(), "gather ray") + ", ",
                Console.count(rays.shadow(), "shadow ray"));
        Optional<Clipping> clipping = console.report().isJson() ? output.clipping(scene, film, output.file()) : Optional.empty();
        console.report().setResult(new RenderReport(output.file().toString(), title, film.width(), film.height(), scene.picture().depth(),
                milliseconds, !Engines.isFastestInUse(), RaysReport.of(rays), clipping.map(Clipping::clippedPixels).orElse(null),
                clipping.map(Clipping::brightest).orElse(null)));
    }
}
