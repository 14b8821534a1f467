package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import lightning.base.file.ShippedFile;
import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.bench.accuracy.PreviewCost;
import lightning.bench.accuracy.UpdateSaving;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovScene;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Makes every kind of edit on a scene, with pictures and times. */
@Command(name = "tour", header = "Make every kind of edit on a scene, with pictures and times.", abbreviateSynopsis = true,
        description = {
            "Traces the scene, makes the paper's edits on it one by one, each from the scene as it is, writes the pictures, and",
            "prints a line for each edit: its plan, the rows of light layers it touched, its shadow rays, its time and a full",
            "trace's (medians of repetitions in turns), what it saves, what the paper saved on its own scene and machine, the",
            "cap, and whether the picture equals a full trace in every bit. Edits reach mirrors at once; --reflections stale leaves",
            "mirrors as they were, which is what the paper measured, and the full trace compared for equality shows the same in its",
            "mirrors.",
            "",
            "The cap is what the edit could save at most if it cast its rays as fast as the full trace casts its own, and moved",
            "its bytes as fast as memory does: a fast full trace and few lights leave less to save.",
            "",
            "With stale reflections the line '- its mirrors' then brings the edit of the position to the mirrors, as the button",
            "Update Reflections does.",
            "The exit code is 1 if a picture is not equal."},
        footer = {
            "Examples:",
            "  lightning tour",
            "  lightning tour scenes/balls.jen -o balls-tour --size 640x480 --repetitions 3",
            "  lightning tour scenes/bird.jen --reflections stale",
            "  lightning tour scenes/house.jen --povray"})
final class TourCommand implements Callable<Integer> {
    private static final Path DEFAULT_SCENE = ShippedFile.SCENES.resolve("bird.jen");
    private final Console console;

    @Parameters(index = "0", arity = "0..1", paramLabel = "scene.jen", description = "The scene; scenes/bird.jen without it.")
    private Path scene;
    @Option(names = {"-o", "--output"}, paramLabel = "DIR", defaultValue = "lightning-tour",
            description = "The folder for the pictures, made if it is not there; lightning-tour without it.")
    private Path folder;
    @Option(names = "--size", paramLabel = "WxH", converter = PictureDimensions.Converter.class, defaultValue = "1920x1080",
            description = "Pixels; 1920x1080 without it.")
    private PictureDimensions size;
    @Option(names = "--povray", description = "Also measure the full trace beside the installed POV-Ray's of the same scene.")
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
        Scene read = JenReader.read(file).scene();
        Scene sized = read.withPicture(read.picture().withSize(size.width(), size.height()));
        MemoryEstimate.check(sized, RenderOptions.DEFAULT.withThreads(threads.count()));
        Optional<PovRayRunner> pov = povray ? PovRayRunner.find() : Optional.empty();
        if (povray && pov.isEmpty()) {
            throw new BadInputException("--povray: there is no program povray on the PATH; install POV-Ray 3.7 (Debian package povray)");
        }
        Files.createDirectories(folder);
        console.print("%s at %d x %d pixels, depth %d, %s; pictures go to %s", file, size.width(), size.height(),
                read.picture().depth(), Console.count(threads.count(), "thread"), folder);
        List<PaperCase> cases = PaperCases.of(sized);
        try (UpdateSavingMeter meter = new UpdateSavingMeter(options(), repetitions.count());
                ProgressBar bar = new ProgressBar(console, "tour")) {
            return runTour(sized, cases, pov, meter, bar) ? ExitCode.OK : ExitCode.CHECK_FAILED;
        }
    }

    private RenderOptions options() {
        return RenderOptions.DEFAULT.withReflections(reflections.value()).withThreads(threads.count());
    }

    private boolean runTour(Scene sized, List<PaperCase> cases, Optional<PovRayRunner> pov, UpdateSavingMeter meter, ProgressBar bar)
            throws Exception {
        int steps = cases.size() + 2;
        bar.report(0, steps);
        meter.warmUp(cases.stream().map(edit -> new Scene[] {edit.before(), edit.after()}).toList(), bar.cancellationOnly());
        FirstPassCost first = meter.firstPass(sized, bar.cancellationOnly());
        writePicture("first-pass", meter.renderer().film());
        var table = new TourTable(console);
        bar.erase();
        table.printFirstPass(first, meter.bytesPerMs());
        table.printPreview(PreviewCost.of(sized, threads.count(), bar.cancellationOnly()));
        if (pov.isPresent()) {
            PovScene exported = PovScene.of(sized, "scene");
            table.printPovRay(meter.compareWith(sized, () -> pov.get().traceMs(exported, size.width(), size.height(), threads.count()),
                    bar.cancellationOnly()));
        }
        table.printHeader();
        boolean allEqual = true;
        for (int i = 0; i < cases.size(); i++) {
            bar.report(i + 1, steps);
            PaperCase edit = cases.get(i);
            List<Scene> scenes = edit.scenes();
            UpdateSaving saving = meter.update(scenes.get(scenes.size() - 2), scenes.getLast(), bar.cancellationOnly());
            writePicture(edit.name(), meter.renderer().film());
            bar.erase();
            table.printRow(edit.name(), edit.paperSaving(), saving);
            allEqual &= saving.isVerified();
        }
        bar.report(steps - 1, steps);
        allEqual &= updateMirrors(cases, table, meter, bar);
        table.printFooter();
        return allEqual;
    }

    /** Brings the first edit that moves a light to the mirrors: the button Update Reflections. */
    private boolean updateMirrors(List<PaperCase> cases, TourTable table, UpdateSavingMeter meter, ProgressBar bar) throws IOException {
        Optional<PaperCase> edit = cases.stream().filter(c -> c.name().equals("position")).findFirst();
        if (edit.isEmpty() || reflections.value() == ReflectionMode.CURRENT) {
            return true;
        }
        UpdateSaving saving = meter.reflections(edit.get().before(), edit.get().after(), bar.cancellationOnly());
        writePicture("position-mirrored", meter.renderer().film());
        bar.erase();
        table.printRow("- its mirrors", Double.NaN, saving);
        return saving.isVerified();
    }

    private void writePicture(String name, Film film) throws IOException {
        ImageFile.write(folder.resolve(name.toLowerCase(Locale.ROOT) + ".png"), film, ViewTransform.DEFAULT);
    }
}
