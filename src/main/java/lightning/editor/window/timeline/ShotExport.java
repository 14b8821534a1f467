package lightning.editor.window.timeline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.file.SafeFile;
import lightning.base.work.Memory;
import lightning.base.work.Progress;
import lightning.format.picture.PictureFile;
import lightning.format.picture.PictureFormat;
import lightning.render.image.ViewTransform;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.scene.Picture;
import lightning.scene.shot.AnimatedScene;
import lightning.shot.movie.Ffmpeg;
import lightning.shot.movie.FrameFiles;
import lightning.shot.movie.FrameRun;
import lightning.shot.movie.MovieKind;
import lightning.shot.movie.MovieWriter;

/**
 * Frames on their way to files, whatever is edited meanwhile.
 *
 * @param to   a folder for numbered pictures, a file for a film
 * @param name what pictures are called before their number
 */
record ShotExport(AnimatedScene scene, int first, int last, ShotKind kind, ViewTransform view, Path to, String name) {
    /** Hears how many frames are there. */
    interface Listener {
        void written(int frames);
    }

    int frames() {
        return last - first + 1;
    }

    /** Writes all; waits until they are there. Pictures that are finished stay where it is cancelled, a film does not. */
    void write(Progress progress, Listener listener) throws IOException {
        // What cannot be is told before the first is begun.
        try {
            IntStream.rangeClosed(first, last).forEach(scene::at);
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
        if (kind.movie().isEmpty()) {
            var files = new FrameFiles(to, name, kind.ending());
            run(progress, listener, PictureFormat.of(files.file(first)).bytesToWrite(picture().width(), picture().height()),
                    (frame, film, _) -> PictureFile.write(files.file(frame), film, view, kind.bits()));
        } else {
            MovieKind movie = kind.movie().get();
            Ffmpeg ffmpeg = Ffmpeg.required();
            SafeFile.at(to).writeByName(temporary -> {
                try (var writer = new MovieWriter(ffmpeg, movie, scene.shot().orElseThrow().rate(), view, temporary)) {
                    run(progress, listener, MovieWriter.bytes(picture()), (_, film, _) -> writer.add(film));
                    writer.finish();
                }
            });
        }
    }

    private Picture picture() {
        return scene.still().picture();
    }

    private void run(Progress progress, Listener listener, long beside, FrameRun.Listener sink) throws IOException {
        List<Integer> all = IntStream.rangeClosed(first, last).boxed().toList();
        Options options = Options.DEFAULT.withReflections(Reflections.CURRENT).withMemory(Memory.available() - beside);
        FrameRun.render(all, scene::at, options, progress, (frame, film, update) -> {
            sink.rendered(frame, film, update);
            listener.written(frame - first + 1);
        });
    }
}
