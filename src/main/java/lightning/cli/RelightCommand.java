package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import lightning.base.file.ParentFolder;
import lightning.base.work.WorkerPool;
import lightning.cli.option.LayerOptions;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ResidentOption;
import lightning.cli.option.ThreadsOption;
import lightning.cli.option.UpdateOptions;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.output.StepFiles;
import lightning.cli.output.StepPictureOutput;
import lightning.cli.report.RaysReport;
import lightning.cli.report.RelightReport;
import lightning.format.jen.InputFiles;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenFile;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Difference;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Traces a scene, applies edits and re-renders only what each edit changed. */
@Command(name = "relight", header = "Edit lights and materials and re-render only what changed.", abbreviateSynopsis = true,
        description = {
            "Traces the scene once, then applies the edits in order. The edits up to a --then (or the end) form a group that is "
                    + "rendered as one. Prints a line for each group: its plan, the rows of light layers it changed, its shadow rays, its "
                    + "time, and whether the image is exact or its error bound.",
            "",
            "Then repeats each group, alternating with full traces of the same image until both are warmed up, to measure the time "
                    + "saved. --no-savings skips this. The savings are left out if the timing is too noisy.",
            "",
            "--verify traces each edited scene in full and counts the pixels and values that differ. The exit code is 1 if an image "
                    + "is less accurate than promised: bit-identical with --accuracy exact, within the printed bound with ratio. With "
                    + "--reflections stale, images are compared with a full trace with outdated reflections; a second count shows how "
                    + "many pixels 'Update Reflections' would change."},
        footer = {
            "Examples:",
            "  lightning relight scenes/bird.jen -o red.png --set \"sun.color=1 0 0\"",
            "  lightning relight scenes/bird.jen -o b.png --case color --then --delete sun",
            "  lightning relight scenes/bird.jen -o feet.png --case position-feet --verify",
            "  lightning relight scenes/balls.jen -o b.png --set material:jade.shininess=5",
            "  lightning relight scenes/bird.jen -o %%d.png --case color --then --delete sun",
            "  lightning relight scenes/bird.jen -o new.png --delete sun --save new.jen"})
final class RelightCommand implements Callable<Integer> {
    /** Limit for the warm-up of one group's timing, in milliseconds of own work. */
    static final double WARM_UP_MS = 5000;

    private final Console console;
    private final KeptRenderer kept;

    @Mixin
    private SceneFile input;
    @Mixin
    private StepPictureOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private LayerOptions layers;
    @Mixin
    private ResidentOption resident;
    @ArgGroup(exclusive = true, multiplicity = "1..*", heading = "%nEdits:%n")
    private List<EditStep> steps;
    @Mixin
    private UpdateOptions updates;
    @Option(names = "--verify", description = "Verify each image against full traces.")
    private boolean verify;
    @Option(names = "--no-savings",
            description = "Skip measuring the time saved, which takes a second or more per group.")
    private boolean skipsSavings;
    @Option(names = "--save", paramLabel = "edited.jen",
            description = "Write the edited scene; keeps comments, order and unedited text.")
    private @Nullable Path saveFile;

    private final List<RelightReport.Step> reports = new ArrayList<>();

    RelightCommand(Console console, KeptRenderer kept) {
        this.console = console;
        this.kept = kept;
    }

    @Override
    public Integer call() throws Exception {
        String stem = JenFile.stem(input.path().getFileName().toString());
        StepFiles pictures = new StepFiles(output.file(), stem);
        Optional<StepFiles> mattes = layers.mattes().map(file -> new StepFiles(file, stem));
        output.checkFormat(pictures.file(1));
        layers.checkFormats(output, pictures.file(1));
        if (saveFile != null) {
            PictureOutput.checkFile(saveFile);
        }
        JenDocument document = input.read(console);
        List<Scene> edited = editedScenes(document.scene());
        int last = edited.size();
        InputFiles inputs =
                output.withViewFile(InputFiles.of(input.path(), Stream.concat(Stream.of(document.scene()), edited.stream()).toList()));
        output.printViewNotes(console);
        pictures.check(last, inputs);
        if (mattes.isPresent()) {
            mattes.get().check(last, inputs);
        }
        if (saveFile != null) {
            InputFiles.referencedBy(edited.getLast(), ParentFolder.of(input.path())).check(saveFile);
        }
        Scene before = picture.apply(document.scene());
        layers.checkSize(before.picture());
        RenderOptions options = updates.apply(RenderOptions.DEFAULT.withThreads(threads.count()))
                .withMemory(PictureOutput.availableMemory(before, pictures.file(1)));
        boolean allKept = true;
        UpdateResult first;
        Renderer renderer = kept.with(options);
        try (WorkerPool workers = new WorkerPool(threads.count());
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            first = renderer.renderOrClear(before, bar);
            console.print("%s: %.1f ms, %s", KeptRenderer.title(first), first.milliseconds(), Console.count(first.rays().total(), "ray"));
            for (int step = 1; step <= last; step++) {
                Scene scene = picture.apply(edited.get(step - 1));
                Optional<Path> pictureFile = pictures.written(step, last);
                allKept &= relight(output.view(scene), step, pictureFile, false, (r, progress) -> r.render(scene, progress), renderer,
                        workers, bar);
                if (updates.updatesReflectionsLast() && step == last) {
                    allKept &= relight(output.view(scene), step, pictureFile, true, Renderer::updateReflections, renderer, workers, bar);
                }
                Optional<Path> matteFile = mattes.isPresent() ? mattes.get().written(step, last) : Optional.empty();
                write(renderer, pictureFile, matteFile, workers);
            }
        }
        if (saveFile != null) {
            document.withScene(edited.getLast()).save(saveFile);
        }
        console.report().setResult(new RelightReport(output.file().toString(), first.milliseconds(), RaysReport.of(first.rays()), reports,
                saveFile == null ? null : saveFile.toString()));
        return allKept ? ExitCode.OK : ExitCode.CHECK_FAILED;
    }

    private void write(Renderer renderer, Optional<Path> pictureFile, Optional<Path> matteFile, WorkerPool workers) throws IOException {
        layers.write(output, renderer.cache(), renderer.options().engines(), pictureFile, matteFile, Optional.empty(), workers, console);
        if (pictureFile.isPresent()) {
            output.printClipping(renderer.cache().scene(), renderer.film(), pictureFile.get(), console);
        }
    }

    /**
     * Runs an update, prints its summary and verifies it if requested; returns false if it is less accurate than promised.
     *
     * @param number number of the group of edits
     * @param mirrorsOnly whether the update is that of the reflections after the group
     */
    private boolean relight(ViewTransform view, int number, Optional<Path> file, boolean mirrorsOnly, WarmSaving.UpdateStep step,
            Renderer renderer, WorkerPool workers, ProgressBar bar) {
        PixelCache start = renderer.cache();
        WarmSaving.UpdateStep stepWithView = (r, progress) -> {
            r.setView(view.exposure(), view.steepestCurve());
            return step.run(r, progress);
        };
        UpdateResult update = stepWithView.run(renderer, bar);
        Optional<WarmSaving> saving =
                skipsSavings ? Optional.empty() : WarmSaving.RepeatableEdit.of(update, start, renderer.options(), stepWithView)
                        .flatMap(edit -> WarmSaving.measure(edit, workers, WARM_UP_MS, bar));
        AccuracyGuarantee promise = AccuracyGuarantee.of(renderer, update);
        console.print("%s %s", mirrorsOnly ? "mirrors:" : number + ".", describe(update, promise, saving));
        Optional<Verification> verification =
                verify ? Optional.of(promise.verify(renderer.film(), workers, bar)) : Optional.empty();
        verification.ifPresent(v -> console.print("   %s", v.text()));
        reports.add(new RelightReport.Step(number, file.map(Path::toString).orElse(null), mirrorsOnly, update.plan().description(),
                update.rowsTouched(), RaysReport.of(update.rays()), saving.map(s -> s.update().median()).orElse(update.milliseconds()),
                saving.map(s -> s.full().median()).orElse(null), saving.map(WarmSaving::percent).orElse(null), promise.bound(),
                verification.map(RelightCommand::report).orElse(null)));
        return verification.map(Verification::hasPassed).orElse(true);
    }

    private static RelightReport.Verified report(Verification verification) {
        Difference difference = verification.expectedDifference();
        return new RelightReport.Verified(verification.hasPassed(), difference.pixels(), difference.values(), difference.maxAbsolute());
    }

    /** Returns the scene after each group of edits. */
    private List<Scene> editedScenes(Scene scene) throws BadInputException {
        List<Scene> scenes = new ArrayList<>();
        Scene current = scene;
        for (List<EditStep> group : EditStep.splitGroups(steps)) {
            for (EditStep step : group) {
                List<Scene> next = step.apply(current, ParentFolder.of(input.path()));
                scenes.addAll(next.subList(0, next.size() - 1));
                current = next.getLast();
            }
            EditStep.warnUnused(group, current, console);
            scenes.add(current);
        }
        return scenes;
    }

    private static String describe(UpdateResult update, AccuracyGuarantee promise, Optional<WarmSaving> saving) {
        String time = saving.map(s -> Console.text("%.1f ms of a full trace's %.1f (saves %.1f %%)", s.update().median(), s.full().median(),
                s.percent())).orElseGet(() -> Console.text("%.1f ms", update.milliseconds()));
        return Console.text("%s: %s, %s, %s, %s",
                update.plan().description(), Console.count(update.rowsTouched(), "row"),
                Console.count(update.rays().shadow(), "shadow ray")
                        + (update.rays().gather() == 0 ? "" : ", " + Console.count(update.rays().gather(), "ray") + " of indirect light"),
                time,
                promise.text(update));
    }
}
