package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.IntStream;
import lightning.base.file.SafeFile;
import lightning.base.text.Decimal;
import lightning.base.work.Memory;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenFile;
import lightning.render.image.Film;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;
import lightning.shot.movie.Ffmpeg;
import lightning.shot.movie.FrameFiles;
import lightning.shot.movie.FrameRun;
import lightning.shot.movie.MovieKind;
import lightning.shot.movie.MovieWriter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Renders the frames of a shot, one after the other. */
@Command(name = "render", abbreviateSynopsis = true, header = "Render the frames of a shot as numbered pictures or as a film.",
        description = {
            "Each picture is that of its frame's scene in every bit, whichever frame was rendered before it: where only lights changed",
            "since then, only they are computed anew. -o frames makes frames/SCENE-0001.png and so on, -o out/bird.exr makes",
            "out/bird-0001.exr. A picture appears whole or not at all; those that are finished stay when the command is cancelled, and",
            "--resume goes on behind them. -o bird.mp4 (.mov, .mkv, .webm) makes a film of the shot's frames per second, where the program",
            "ffmpeg is installed."},
        footer = {
            "Examples:",
            "  lightning shot render scenes/dusk.jen -o frames",
            "  lightning shot render scenes/dusk.jen --frames 1-24 -o frames --size 150x100 --resume",
            "  lightning shot render scenes/dusk.jen -o dusk.mp4 --view filmic"})
final class ShotRenderCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private FramesOutput output;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Mixin
    private FramesOption frames;
    @Option(names = "--resume", description = "Leaves out frames whose picture is there.")
    private boolean resume;

    ShotRenderCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Optional<MovieKind> movie = MovieKind.of(output.file());
        FrameFiles files = FrameFiles.of(output.file(), JenFile.stem(input.path().getFileName().toString()));
        if (movie.isEmpty()) {
            output.checkKind(files.file(0));
        } else if (resume) {
            throw new BadInput("a film is made whole: --resume is for numbered pictures");
        } else {
            Ffmpeg.required();
        }
        JenDocument document = input.read();
        ShotFrames shot = frames.of(document, input.path());
        FrameRange range = shot.range();
        Scene scene = picture.apply(document.scene());
        shot.check(scene);
        if (movie.isPresent()) {
            film(shot, scene, range, movie.get());
            return ExitCode.DONE;
        }
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
            int there = range.count() - wanted.size();
            console.line("%s %s there",
                    wanted.isEmpty() ? Console.count(there, "frame") : there + " of " + Console.count(range.count(), "frame"),
                    there == 1 ? "was" : "were");
        }
        return ExitCode.DONE;
    }

    private void render(ShotFrames shot, Scene scene, List<Integer> wanted, FrameFiles files) throws Exception {
        Path one = files.file(0);
        run(shot, scene, wanted, PictureOutput.memory(scene, one), (frame, film) -> {
            output.write(film, files.file(frame));
            return files.file(frame).toString();
        });
    }

    /** All frames as a film, which appears whole or not at all. */
    private void film(ShotFrames shot, Scene scene, FrameRange range, MovieKind kind) throws Exception {
        Ffmpeg ffmpeg = Ffmpeg.required();
        PictureOutput.checkFile(output.file());
        List<Integer> all = IntStream.rangeClosed(range.first(), range.last()).boxed().toList();
        SafeFile.at(output.file()).writeByName(temporary -> {
            try (var movie = new MovieWriter(ffmpeg, kind, shot.shot().rate(), output.view(), temporary)) {
                run(shot, scene, all, Memory.available() - MovieWriter.bytes(scene.picture()), (frame, film) -> {
                    movie.add(film);
                    return "frame " + frame;
                });
                movie.finish();
            }
        });
        console.line("%s: %s, %s a second", output.file(), Console.count(all.size(), "frame"), Decimal.text(shot.shot().rate()));
    }

    /** What is done with a frame. */
    private interface Sink {
        /** Takes a picture, which is written over afterwards; returns what it is called. */
        String take(int frame, Film film) throws IOException;
    }

    private void run(ShotFrames shot, Scene scene, List<Integer> wanted, long memory, Sink sink) throws IOException {
        Options options = Options.DEFAULT.withReflections(Reflections.CURRENT).withThreads(threads.count()).withMemory(memory);
        double[] milliseconds = new double[2];
        int[] counts = new int[2];
        try (ProgressBar bar = new ProgressBar(console, "rendering")) {
            FrameRun.render(wanted, frame -> shot.shot().at(scene, frame), options, bar.silent(), (frame, film, update) -> {
                String called = sink.take(frame, film);
                int kind = update.plan() instanceof UpdatePlan.FirstPass ? 0 : 1;
                milliseconds[kind] += update.milliseconds();
                counts[kind]++;
                bar.erase();
                console.line("%s: %s, %.1f ms", called, update.plan().text(), update.milliseconds());
                bar.tiles(counts[0] + counts[1], wanted.size());
            });
        }
        console.line("%s traced in %.1f ms, %d relit in %.1f ms", Console.count(counts[0], "frame"), milliseconds[0], counts[1],
                milliseconds[1]);
    }
}
