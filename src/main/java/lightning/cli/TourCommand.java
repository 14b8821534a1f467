package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import lightning.base.file.ShippedFile;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.PreviewCost;
import lightning.bench.accuracy.UpdateSaving;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.cli.option.PictureDimensions;
import lightning.cli.option.ReflectionsOption;
import lightning.cli.option.RepetitionsOption;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.TourTable;
import lightning.cli.report.RaysReport;
import lightning.cli.report.TourReport;
import lightning.format.image.ImageFile;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovScene;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.MemoryEstimate;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Demonstrates every kind of edit on a scene. */
@Command(name = "tour", header = "Demonstrate every kind of edit, with images and timings.", abbreviateSynopsis = true,
        description = {
            "Traces the scene, applies the paper's edits one by one, each to the original scene, and writes the images. Prints a line "
                    + "for each edit: its plan, the rows of light layers it changed, its shadow rays, its time and that of a full trace "
                    + "(medians of alternating runs), the time saved, the saving reported in the paper (other scene, machine of 1998), the "
                    + "cap, and whether the image is bit-identical to a full trace.",
            "",
            "The cap is the largest possible saving: the edit would cast rays as fast as the full trace and move bytes at full memory "
                    + "bandwidth. A fast full trace and few lights leave less to save.",
            "",
            "Reflections follow each edit. With --reflections stale they stay outdated, as measured in the paper, and images are "
                    + "compared with a full trace with outdated reflections; the line '- its mirrors' then measures Update Reflections "
                    + "after the position edit.",
            "",
            "The exit code is 1 if an image differs from the full trace."},
        footer = {
            "Examples:",
            "  lightning tour",
            "  lightning tour scenes/balls.jen -o balls-tour --size 640x480",
            "  lightning tour scenes/bird.jen --reflections stale",
            "  lightning tour scenes/house.jen --povray"})
final class TourCommand implements Callable<Integer> {
    private static final Path DEFAULT_SCENE = ShippedFile.SCENES.resolve("bird.jen");
    private final Console console;

    @Parameters(index = "0", arity = "0..1", paramLabel = "scene.jen", description = "Scene file (default: scenes/bird.jen).")
    private @Nullable Path scene;
    @Option(names = {"-o", "--output"}, paramLabel = "DIR", defaultValue = "lightning-tour",
            description = "Output folder, created if missing (default: lightning-tour).")
    private Path folder;
    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class, defaultValue = "1920x1080",
            description = "Image size in pixels (default: 1920x1080).")
    private PictureDimensions size;
    @Option(names = "--povray", description = "Also compare the full trace with the installed POV-Ray.")
    private boolean povray;
    @Mixin
    private ReflectionsOption reflections;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private RepetitionsOption repetitions;

    TourCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Path file = ShippedFile.resolve(scene == null ? DEFAULT_SCENE : scene);
        Scene read = SceneFile.read(file, console).scene();
        Scene sized = read.withPicture(read.picture().withSize(size.width(), size.height()));
        MemoryEstimate.check(sized, RenderOptions.DEFAULT.withThreads(threads.count()));
        Optional<PovRayRunner> pov = povray ? PovRayRunner.find() : Optional.empty();
        if (povray && pov.isEmpty()) {
            throw new BadInputException("--povray: program povray not found on the PATH; install POV-Ray 3.7 (Debian package povray)");
        }
        Files.createDirectories(folder);
        console.print("%s at %d x %d pixels, depth %d, %s; writing images to %s", file, size.width(), size.height(),
                read.picture().depth(), Console.count(threads.count(), "thread"), folder);
        List<PaperCase> cases = PaperCases.of(sized);
        try (UpdateSavingMeter meter = new UpdateSavingMeter(options(), repetitions.count());
                ProgressBar bar = new ProgressBar(console, "tour")) {
            return runTour(sized, cases, pov, meter, bar) ? ExitCode.OK : ExitCode.CHECK_FAILED;
        }
    }

    private RenderOptions options() {
        return reflections.apply(RenderOptions.DEFAULT).withThreads(threads.count());
    }

    private boolean runTour(Scene sized, List<PaperCase> cases, Optional<PovRayRunner> pov, UpdateSavingMeter meter, ProgressBar bar)
            throws Exception {
        int steps = cases.size() + 2;
        bar.report(0, steps);
        meter.warmUp(cases.stream().map(edit -> new Scene[] {edit.before(), edit.after()}).toList(), bar.cancellationOnly());
        FirstPassCost first = meter.firstPass(sized, bar.cancellationOnly());
        writePicture("first-pass", meter.renderer().film());
        var table = new TourTable(console);
        table.printFirstPass(first, meter.bytesPerMs());
        table.printPreview(PreviewCost.of(sized, threads.count(), bar.cancellationOnly()));
        if (pov.isPresent()) {
            PovScene exported = PovScene.of(sized, "scene");
            table.printPovRay(meter.compareWith(sized, () -> pov.get().traceMs(exported, size.width(), size.height(), threads.count()),
                    bar.cancellationOnly()));
        }
        table.printHeader();
        List<TourReport.Edit> edits = new ArrayList<>();
        boolean allEqual = true;
        for (int i = 0; i < cases.size(); i++) {
            bar.report(i + 1, steps);
            PaperCase edit = cases.get(i);
            List<Scene> scenes = edit.scenes();
            UpdateSaving saving = meter.update(scenes.get(scenes.size() - 2), scenes.getLast(), bar.cancellationOnly());
            writePicture(edit.name(), meter.renderer().film());
            table.printRow(edit.name(), edit.paperSaving(), saving);
            edits.add(report(edit.name(), edit.paperSaving(), saving));
            allEqual &= saving.isVerified();
        }
        bar.report(steps - 1, steps);
        allEqual &= updateMirrors(cases, table, meter, bar, edits);
        table.printFooter();
        console.report().setResult(new TourReport(ShippedFile.resolve(scene == null ? DEFAULT_SCENE : scene).toString(), folder.toString(),
                size.width(), size.height(), threads.count(), first.first().median(), first.full().median(), first.percentSlower(),
                first.isWarm(), edits));
        return allEqual;
    }

    /** Updates the reflections after the first edit that moves a light, as the button Update Reflections does. */
    private boolean updateMirrors(List<PaperCase> cases, TourTable table, UpdateSavingMeter meter, ProgressBar bar,
            List<TourReport.Edit> edits) throws IOException {
        Optional<PaperCase> edit = cases.stream().filter(c -> c.name().equals("position")).findFirst();
        if (edit.isEmpty() || !reflections.isStale()) {
            return true;
        }
        UpdateSaving saving = meter.reflections(edit.get().before(), edit.get().after(), bar.cancellationOnly());
        writePicture("position-mirrored", meter.renderer().film());
        table.printRow("- its mirrors", Double.NaN, saving);
        edits.add(report("mirrors of position", Double.NaN, saving));
        return saving.isVerified();
    }

    private static TourReport.Edit report(String name, double paper, UpdateSaving saving) {
        return new TourReport.Edit(name, saving.update().plan().description(), saving.update().rowsTouched(),
                RaysReport.of(saving.update().rays()), saving.time().median(), saving.full().median(), saving.percent(), paper,
                saving.maxPercent(), saving.isVerified(), saving.isWarm());
    }

    private void writePicture(String name, Film film) throws IOException {
        ImageFile.write(folder.resolve(name.toLowerCase(Locale.ROOT) + ".png"), film, ViewTransform.DEFAULT);
    }
}
