package lightning.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.AccuracyGuarantee;
import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.format.jen.JenDocument;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.tile.MirrorStorage;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Traces a scene, edits its lights and renders only what each edit changed. */
@Command(name = "relight", header = "Edit lights and materials and render only what the edits changed.", abbreviateSynopsis = true,
        description = {
            "Traces the scene once, then makes the edits in their order. Edits up to a --then (or the end) are made at once and",
            "rendered as one. Each such group gets a line: its plan, the rows of light layers it touched, its shadow rays, its",
            "time, and whether the picture is exact or how far a value may be off. Then it is made again, in turns with a full trace",
            "of the same picture, until both run as fast as they can: that tells what it saves. --no-savings leaves this out, and so",
            "does a line whose times do not come to rest.",
            "",
            "--verify traces each edited scene in full and counts the pixels and values that differ. The exit code is 1 if a",
            "picture is not what was promised: every bit at --accuracy exact, the stated bound at ratio. With --reflections stale",
            "the promise holds for a full trace whose mirrors show the scene of their last update; a second count tells how many",
            "pixels 'Update Reflections' would change."},
        footer = {
            "Examples:",
            "  lightning relight scenes/bird.jen -o red.png --set \"sun.color=1 0 0\" --set sun.intensity=0.3 --verify",
            "  lightning relight scenes/bird.jen -o two.png --set stage.angle=12 --then --delete sun",
            "  lightning relight scenes/bird.jen -o feet.png --case position-feet --update-reflections --verify",
            "  lightning relight scenes/balls.jen -o dull.png --set \"material:gold.reflective=0 0 0\" --set material:jade.shininess=20",
            "  lightning relight scenes/bird.jen -o new.png --add \"fill point intensity=0.5 at=0 3 2\" --save new.jen"})
final class RelightCommand implements Callable<Integer> {
    /** How long the times of one line may take to come to rest, milliseconds of own work. */
    static final double WARM_UP_MS = 5000;

    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private SinglePictureOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @ArgGroup(exclusive = true, multiplicity = "1..*", heading = "Edits:%n")
    private List<EditStep> steps;
    @Option(names = "--accuracy", paramLabel = "ACCURACY", defaultValue = "exact",
            description = "exact (equal to a full trace in every bit) or ratio (the paper's method, with an error bound).")
    private Accuracy accuracy;
    @Mixin
    private ReflectionsOption reflections;
    @Option(names = "--update-reflections",
            description = "As in 1998: mirrors are stale until the last edit was made, and are then updated in a step of their own.")
    private boolean updateReflections;
    private MirrorStorage storage = MirrorStorage.FULL_ROWS;
    @Option(names = "--verify", description = "Check each picture against full traces.")
    private boolean verify;
    @Option(names = "--no-savings",
            description = "Leaves out what each update saves of a full trace, which takes a second or more to measure.")
    private boolean skipsSavings;
    @Option(names = "--save", paramLabel = "edited.jen",
            description = "Writes the edited scene; comments, order and numbers that were not edited keep their characters.")
    private Path saveFile;

    /** The names of {@link MirrorStorage} on the command line. */
    enum Storage { ROWS, SHAPES }

    @Option(names = "--storage", paramLabel = "WHAT", defaultValue = "rows",
            description = "What is kept of mirror images: rows (fast) or shapes (small).")
    private void setStorage(Storage value) {
        storage = switch (value) {
            case ROWS -> MirrorStorage.FULL_ROWS;
            case SHAPES -> MirrorStorage.SMALLEST;
        };
    }

    RelightCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        output.check();
        if (saveFile != null) {
            PictureOutput.checkFile(saveFile);
        }
        JenDocument document = input.read();
        List<Scene> edited = editedScenes(document.scene());
        Scene before = picture.apply(document.scene());
        RenderOptions options =
                new RenderOptions(accuracy, updateReflections ? reflections.staleValue() : reflections.value(), storage, threads.count())
                        .withMemory(output.availableMemory(before));
        boolean allKept = true;
        try (Renderer renderer = new Renderer(options); WorkerPool workers = new WorkerPool(threads.count());
                ProgressBar bar = new ProgressBar(console, "tracing")) {
            UpdateResult first = renderer.render(before, bar);
            console.print("first pass: %.1f ms, %s", first.milliseconds(), Console.count(first.rays().total(), "ray"));
            for (int group = 0; group < edited.size(); group++) {
                Scene scene = picture.apply(edited.get(group));
                allKept &= relight(group + 1 + ".", (r, progress) -> r.render(scene, progress), renderer, workers, bar);
            }
            if (updateReflections) {
                allKept &= relight("mirrors:", Renderer::updateReflections, renderer, workers, bar);
            }
            output.write(renderer.film(), threads.count(), console);
        }
        if (saveFile != null) {
            document.withScene(edited.getLast()).save(saveFile);
        }
        return allKept ? ExitCode.OK : ExitCode.CHECK_FAILED;
    }

    /** Makes an update and prints what it did, and whether its promise was kept where that is asked; returns false if it was not. */
    private boolean relight(String title, WarmSaving.UpdateStep step, Renderer renderer, WorkerPool workers, ProgressBar bar) {
        PixelCache start = renderer.cache();
        WarmSaving.UpdateStep stepWithView = (r, progress) -> {
            r.setView(output.view().exposure(), output.view().steepestCurve());
            return step.run(r, progress);
        };
        UpdateResult update = stepWithView.run(renderer, bar);
        Optional<WarmSaving> saving =
                skipsSavings ? Optional.empty() : WarmSaving.RepeatableEdit.of(update, start, renderer.options(), stepWithView)
                        .flatMap(edit -> WarmSaving.measure(edit, workers, WARM_UP_MS, bar));
        console.print("%s %s", title, describe(update, AccuracyGuarantee.of(renderer, update), saving));
        if (!verify) {
            return true;
        }
        Verification verification = AccuracyGuarantee.of(renderer, update).verify(renderer.film(), workers, bar);
        console.print("   %s", verification.text());
        return verification.hasPassed();
    }

    /** The scene after each group of edits. */
    private List<Scene> editedScenes(Scene scene) throws BadInputException {
        List<Scene> scenes = new ArrayList<>();
        Scene current = scene;
        for (List<EditStep> group : EditStep.splitGroups(steps)) {
            for (EditStep step : group) {
                List<Scene> next = step.apply(current, input.path().toAbsolutePath().getParent());
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
                Console.count(update.rays().shadow(), "shadow ray"), time,
                promise.text(update));
    }
}
