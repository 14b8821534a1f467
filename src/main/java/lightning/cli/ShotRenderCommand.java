package lightning.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import lightning.jen.JenDocument;
import lightning.relight.PictureTooLarge;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.relight.plan.Reflections;
import lightning.relight.plan.UpdatePlan;
import lightning.relight.tile.Options;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.warmup.LateWarmUp;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Renders the frames of a shot, one after the other. */
@Command(name = "render", abbreviateSynopsis = true, header = "Render the frames of a shot as numbered pictures.",
        description = {
            "Each picture is that of its frame's scene in every bit, whichever frame was rendered before it: where only lights changed",
            "since then, only they are computed anew. -o frames makes frames/SCENE-0001.png and so on, -o out/bird.exr makes",
            "out/bird-0001.exr. A picture appears whole or not at all; those that are finished stay when the command is cancelled, and",
            "--resume goes on behind them."},
        footer = {
            "Examples:",
            "  lightning shot render scenes/dusk.jen -o frames",
            "  lightning shot render scenes/dusk.jen --frames 1-24 -o frames --size 150x100 --resume"})
final class ShotRenderCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private PictureOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--frames", paramLabel = "FIRST-LAST", converter = FrameRange.Converter.class,
            description = "Which frames, as in 1-240 or 17; those of the shot without it.")
    private FrameRange frames;
    @Option(names = "--resume", description = "Leaves out frames whose picture is there.")
    private boolean resume;

    ShotRenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        FrameFiles files = FrameFiles.of(output.file(), input.path());
        output.checkKind(files.file(0));
        JenDocument document = input.read();
        Shot shot = document.shot().orElseThrow(() -> new BadInput(Console.text(
                "%s: has no shot; docs/jen-format.md tells how a shot block says one", input.path())));
        FrameRange range = frames == null ? new FrameRange(shot.first(), shot.last()) : frames;
        if (range.count() > FrameRange.MOST) {
            throw new BadInput("the shot has " + range.count() + " frames; choose at most " + FrameRange.MOST + " of them with --frames");
        }
        Scene scene = picture.apply(document.scene());
        checkAll(shot, scene, range);
        files.makeFolder();
        List<Integer> wanted = new ArrayList<>();
        for (int frame = range.first(); frame <= range.last(); frame++) {
            Path file = files.file(frame);
            if (!resume || !Files.isRegularFile(file)) {
                PictureOutput.checkFile(file);
                wanted.add(frame);
            }
        }
        if (!wanted.isEmpty()) {
            render(shot, scene, wanted, files);
        }
        if (wanted.size() < range.count()) {
            console.line("%d of %d frames were there", range.count() - wanted.size(), range.count());
        }
        return ExitCode.DONE;
    }

    /** Before the first picture is begun. */
    private static void checkAll(Shot shot, Scene scene, FrameRange range) throws BadInput {
        for (int frame = range.first(); frame <= range.last(); frame++) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException();
            }
            at(shot, scene, frame);
        }
    }

    private static Scene at(Shot shot, Scene scene, int frame) throws BadInput {
        try {
            return shot.at(scene, frame);
        } catch (IllegalArgumentException e) {
            throw new BadInput(e.getMessage());
        }
    }

    private void render(Shot shot, Scene scene, List<Integer> wanted, FrameFiles files) throws Exception {
        Options options = Options.DEFAULT.withReflections(Reflections.CURRENT).withThreads(threads.count())
                .withMemory(PictureOutput.memory(scene, files.file(0)));
        double[] milliseconds = new double[2];
        int[] counts = new int[2];
        try (var _ = new LateWarmUp(at(shot, scene, wanted.getFirst()));
                Renderer renderer = new Renderer(options);
                ProgressBar bar = new ProgressBar(console, "rendering")) {
            for (int i = 0; i < wanted.size(); i++) {
                int frame = wanted.get(i);
                Update update = render(renderer, at(shot, scene, frame), bar);
                output.write(renderer.film(), files.file(frame));
                int kind = update.plan() instanceof UpdatePlan.FirstPass ? 0 : 1;
                milliseconds[kind] += update.milliseconds();
                counts[kind]++;
                bar.erase();
                console.line("%s: %s, %.1f ms", files.file(frame), update.plan().text(), update.milliseconds());
                bar.tiles(i + 1, wanted.size());
            }
        }
        console.line("%d frames traced in %.1f ms, %d relit in %.1f ms", counts[0], milliseconds[0], counts[1], milliseconds[1]);
    }

    /** A first pass that does not fit beside what is known of the frame before begins without that. */
    private static Update render(Renderer renderer, Scene scene, ProgressBar bar) {
        try {
            return renderer.render(scene, bar.silent());
        } catch (PictureTooLarge e) {
            if (!renderer.hasPicture()) {
                throw e;
            }
            renderer.forget();
            return renderer.render(scene, bar.silent());
        }
    }
}
