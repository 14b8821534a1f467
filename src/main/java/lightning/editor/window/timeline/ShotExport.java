package lightning.editor.window.timeline;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import lightning.base.file.AtomicFile;
import lightning.base.text.RefusalException;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.InputFiles;
import lightning.render.RenderOptions;
import lightning.render.image.ViewTransform;
import lightning.scene.PictureSettings;
import lightning.scene.shot.AnimatedScene;
import lightning.shot.movie.Ffmpeg;
import lightning.shot.movie.FrameFiles;
import lightning.shot.movie.FrameSequenceRenderer;
import lightning.shot.movie.MovieFormat;
import lightning.shot.movie.MovieWriter;

/**
 * Export of frames to files, from a snapshot of the scene.
 *
 * @param target folder of numbered images, or a video file
 * @param name prefix of the numbered images' file names
 * @param inputs files of the scene, which are not replaced
 */
record ShotExport(AnimatedScene scene, int first, int last, ShotFormat format, ViewTransform view, Path target, String name,
        InputFiles inputs) {
    int frames() {
        return last - first + 1;
    }

    /** Writes all frames; blocks until done. Canceling keeps finished images, but no video. */
    void write(Progress progress, IntConsumer listener) throws IOException {
        // Checks all frames first, so that invalid keyframes fail before the first render.
        try {
            IntStream.rangeClosed(first, last).forEach(scene::sceneAt);
        } catch (RefusalException e) {
            throw new IOException(e.getMessage(), e);
        }
        if (format.movie().isEmpty()) {
            var files = new FrameFiles(target, name, format.extension());
            for (int frame = first; frame <= last; frame++) {
                inputs.check(files.file(frame));
            }
            renderFrames(progress, listener, ImageFormat.of(files.file(first)).bytesToWrite(picture().width(), picture().height()),
                    (frame, cache, _) -> ImageFile.write(files.file(frame), cache.film(), view, format.bits()));
        } else {
            MovieFormat movie = format.movie().get();
            Ffmpeg ffmpeg = Ffmpeg.require();
            inputs.check(target);
            AtomicFile.of(target).writeToPath(temporary -> {
                try (var writer = new MovieWriter(ffmpeg, movie, scene.shot().orElseThrow().rate(), view, temporary)) {
                    renderFrames(progress, listener, MovieWriter.requiredBytes(picture()), (_, cache, _) -> writer.add(cache.film()));
                    writer.finish();
                }
            });
        }
    }

    private PictureSettings picture() {
        return scene.base().picture();
    }

    private void renderFrames(Progress progress, IntConsumer listener, long reservedBytes, FrameSequenceRenderer.Listener sink)
            throws IOException {
        List<Integer> frameNumbers = IntStream.rangeClosed(first, last).boxed().toList();
        RenderOptions options =
                RenderOptions.DEFAULT.withMemory(HeapBudget.availableBytes() - reservedBytes);
        FrameSequenceRenderer.render(frameNumbers, scene::sceneAt, options, progress, (frame, cache, update) -> {
            sink.frameRendered(frame, cache, update);
            listener.accept(frame - first + 1);
        });
    }
}
