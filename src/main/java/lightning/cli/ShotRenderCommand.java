package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import lightning.base.file.AtomicFile;
import lightning.base.text.DecimalNumber;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.cli.option.FrameRange;
import lightning.cli.option.LayerOptions;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.ResidentOption;
import lightning.cli.option.ShotFrames;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.FrameSequenceOutput;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.ShotRenderReport;
import lightning.format.jen.InputFiles;
import lightning.format.sequence.SequenceReader;
import lightning.layer.ShotFrame;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import lightning.shot.movie.Ffmpeg;
import lightning.shot.movie.FrameFiles;
import lightning.shot.movie.FrameSequenceRenderer;
import lightning.shot.movie.MovieFormat;
import lightning.shot.movie.MovieWriter;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Renders the frames of a shot in order. */
@Command(name = "render", abbreviateSynopsis = true, header = "Render the frames of a shot to numbered images or a video.",
        description = {
            "Each image is bit-identical to a full trace of its frame. If only lights changed since the previous frame, only they are "
                    + "recomputed.",
            "",
            "-o frames writes frames/SCENE-0001.png and so on, -o out/bird.exr writes out/bird-0001.exr. Image files appear only when "
                    + "complete; finished ones remain if the command is canceled, and --resume continues after them. -o bird.mp4 "
                    + "writes a video at the shot's frame rate (mp4, mov, mkv or webm; needs ffmpeg).",
            "",
            "A sequence in place of the scene (.json) is several shots with one light rig. -o frames writes frames/SHOT-0001.png "
                    + "and so on, -o out/a.exr writes out/SHOT-0001.exr; --shots chooses some of them."},
        footer = {
            "Examples:",
            "  lightning shot render scenes/dusk.jen -o frames",
            "  lightning shot render scenes/dusk.jen --frames 1-24 -o frames --resume",
            "  lightning shot render scenes/dusk.jen -o a.exr --layers --cryptomatte a.exr",
            "  lightning shot render scenes/dusk.jen -o dusk.mp4 --view filmic"})
final class ShotRenderCommand implements Callable<Integer> {
    /** Added to the name of a shot for the files of its mattes. */
    private static final String MATTES = "mattes";

    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private FrameSequenceOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private ShotParts chosen;
    @Mixin
    private LayerOptions layers;
    @Mixin
    private ResidentOption resident;
    @Option(names = "--resume", description = "Skip frames whose image exists.")
    private boolean resume;

    private final List<ShotRenderReport.Frame> reports = new ArrayList<>();
    /** Milliseconds of traced and of relit frames. */
    private final double[] milliseconds = new double[2];
    /** Number of traced and of relit frames. */
    private final int[] counts = new int[2];

    ShotRenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Optional<MovieFormat> movie = MovieFormat.of(output.file());
        if (movie.isPresent() && SequenceReader.isSequence(input.path())) {
            throw new BadInputException("a video has one shot; a sequence is rendered to numbered images");
        }
        if (movie.isEmpty()) {
            FrameFiles files = FrameFiles.of(output.file(), "a");
            output.checkFormat(files.file(0));
            layers.checkFormats(output, files.file(0));
        } else if (layers.usedOption().isPresent()) {
            throw new BadInputException(layers.usedOption().get() + " works only for numbered images, not for a video");
        } else if (resume) {
            throw new BadInputException("--resume works only for numbered images, not for a video");
        } else {
            Ffmpeg.require();
        }
        ShotParts.Parts shots = chosen.read(input.path(), picture, console);
        ShotParts.Part first = shots.parts().getFirst();
        for (ShotParts.Part part : shots.parts()) {
            layers.checkSize(part.scene().picture());
        }
        int skipped = 0;
        output.printViewNotes(console);
        if (movie.isPresent()) {
            PictureOutput.checkFile(output.file(), inputs(first));
            writeMovie(first.frames(), first.scene(), first.frames().range(), movie.get());
        }
        for (ShotParts.Part part : movie.isPresent() ? List.<ShotParts.Part>of() : shots.parts()) {
            FrameFiles files = FrameFiles.of(output.file(), part.name());
            Optional<FrameFiles> mattes = layers.mattes().map(file -> FrameFiles.of(file, part.name()));
            if (shots.areOfSequence()) {
                String stem = mattes.isPresent() && files.equals(mattes.get()) ? part.name() : part.name() + "-" + MATTES;
                mattes = mattes.map(to -> named(to, stem));
                files = named(files, part.name());
            }
            files.createFolder();
            skipped += renderMissing(part.frames(), part.scene(), inputs(part), files, mattes);
        }
        report(first.frames().shot().rate(), movie.isPresent() ? output.file().toString() : null, skipped);
        return ExitCode.OK;
    }

    private InputFiles inputs(ShotParts.Part part) {
        return output.withViewFile(InputFiles.of(part.file(), List.of(part.scene())));
    }

    private static FrameFiles named(FrameFiles files, String stem) {
        return new FrameFiles(files.folder(), stem, files.extension());
    }

    /** Renders the frames whose files are missing, or all; returns the number of the others. */
    private int renderMissing(ShotFrames shot, Scene scene, InputFiles inputs, FrameFiles files, Optional<FrameFiles> mattes)
            throws Exception {
        FrameRange range = shot.range();
        List<Integer> missing = new ArrayList<>();
        for (int number = range.first(); number <= range.last(); number++) {
            int frame = number;
            List<Path> written = new ArrayList<>(List.of(files.file(frame)));
            mattes.map(matte -> matte.file(frame)).ifPresent(written::add);
            if (!resume || !written.stream().allMatch(Files::isRegularFile)) {
                for (Path file : written) {
                    PictureOutput.checkFile(file, inputs);
                }
                missing.add(frame);
            }
        }
        if (!missing.isEmpty()) {
            render(shot, scene, missing, files, mattes);
        }
        int existing = range.count() - missing.size();
        if (existing > 0) {
            console.print("%s already rendered",
                    missing.isEmpty() ? Console.count(existing, "frame") : existing + " of " + Console.count(range.count(), "frame"));
        }
        return existing;
    }

    private void report(double rate, @Nullable String file, int skipped) {
        console.report().setResult(
                new ShotRenderReport(file, rate, skipped, counts[0], milliseconds[0], counts[1], milliseconds[1], reports));
    }

    private void render(ShotFrames shot, Scene scene, List<Integer> frames, FrameFiles files, Optional<FrameFiles> mattes)
            throws Exception {
        Path firstFile = files.file(0);
        try (WorkerPool workers = new WorkerPool(layers.usedOption().isPresent() ? threads.count() : 1)) {
            renderFrames(shot, scene, frames, PictureOutput.availableMemory(scene, firstFile), (frame, cache) -> {
                layers.write(output, cache, RenderOptions.DEFAULT.engines(), Optional.of(files.file(frame)),
                        mattes.map(matte -> matte.file(frame)), Optional.of(ShotFrame.of(shot.shot(), scene, frame)), workers, console);
                return files.file(frame).toString();
            });
        }
    }

    /** Renders all frames to a video, which appears only when complete. */
    private void writeMovie(ShotFrames shot, Scene scene, FrameRange range, MovieFormat kind) throws Exception {
        Ffmpeg ffmpeg = Ffmpeg.require();
        List<Integer> frames = IntStream.rangeClosed(range.first(), range.last()).boxed().toList();
        AtomicFile.of(output.file()).writeToPath(temporary -> {
            try (var movie = new MovieWriter(ffmpeg, kind, shot.shot().rate(), output.view(scene), temporary)) {
                renderFrames(shot, scene, frames, HeapBudget.availableBytes() - MovieWriter.requiredBytes(scene.picture()),
                        (frame, cache) -> {
                            movie.add(cache.film());
                            return "frame " + frame;
                        });
                movie.finish();
            }
        });
        console.print("%s: %s, %s fps", output.file(), Console.count(frames.size(), "frame"),
                DecimalNumber.format(shot.shot().rate()));
    }

    /** Receives rendered frames. */
    private interface FrameSink {
        /** Receives an image; returns its display name. */
        String write(int frame, PixelCache cache) throws IOException;
    }

    private void renderFrames(ShotFrames shot, Scene scene, List<Integer> frames, long memory, FrameSink sink) throws IOException {
        RenderOptions options =
                RenderOptions.DEFAULT.withThreads(threads.count()).withMemory(memory);
        try (ProgressBar bar = new ProgressBar(console, "rendering")) {
            FrameSequenceRenderer.render(frames, frame -> shot.shot().sceneAt(scene, frame), options, bar.cancellationOnly(),
                    (frame, cache, update) -> {
                        String name = sink.write(frame, cache);
                        int index = update.plan() instanceof UpdatePlan.FirstPass ? 0 : 1;
                        milliseconds[index] += update.milliseconds();
                        counts[index]++;
                        String image = MovieFormat.of(output.file()).isPresent() ? null : name;
                        reports.add(new ShotRenderReport.Frame(frame, image, update.plan().description(), update.milliseconds()));
                        console.print("%s: %s, %.1f ms", name, update.plan().description(), update.milliseconds());
                        bar.report(counts[0] + counts[1], frames.size());
                    });
        }
        console.print("%s traced in %.1f ms, %d relit in %.1f ms", Console.count(counts[0], "frame"), milliseconds[0], counts[1],
                milliseconds[1]);
    }
}
