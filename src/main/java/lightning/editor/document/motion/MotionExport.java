package lightning.editor.document.motion;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.format.image.ImageFile;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;
import lightning.scene.value.SceneLimits;
import lightning.shot.movie.FrameSequenceRenderer;

/**
 * Export of a recorded shot as numbered images, evenly spaced from start to end. Each is exact, reflections included.
 *
 * @param scene        scene without the moving light
 * @param recordedShot shot of a light of the scene
 * @param pictureCount number of images, 1…{@value #MAX_PICTURES}
 * @param view         view transform from linear light to display pixels
 */
public record MotionExport(Scene scene, RecordedShot recordedShot, int pictureCount, ViewTransform view) {
    public static final int MAX_PICTURES = 100_000;
    private static final int MIN_DIGITS = 4;

    public MotionExport {
        SceneLimits.checkRange("the number of frames", pictureCount, 1, MAX_PICTURES);
        recordedShot.shot().check(scene);
    }

    /** Returns the scene of one image, 0 ≤ {@code number} &lt; {@link #pictureCount}. */
    public Scene scene(int number) {
        double share = pictureCount == 1 ? 0 : (double) number / (pictureCount - 1);
        return recordedShot.shot().sceneAt(scene, share * recordedShot.shot().last());
    }

    /** Returns the file name of one image: {@code name-0001.png} for the first. */
    public String file(String name, int number) {
        int digits = Math.max(MIN_DIGITS, Integer.toString(pictureCount).length());
        return name + "-" + String.format(Locale.ROOT, "%0" + digits + "d", number + 1) + ".png";
    }

    /**
     * Renders and writes all images; blocks until they are written.
     *
     * @param name     prefix of the file names, before the number
     * @param progress receives the tiles of each image, and can cancel
     * @param listener receives the number of written images
     * @throws IOException           if an image cannot be written; earlier ones are kept
     * @throws CancellationException if the progress canceled; finished images are kept
     */
    public void write(Path folder, String name, Progress progress, IntConsumer listener) throws IOException {
        FrameSequenceRenderer.render(IntStream.range(0, pictureCount).boxed().toList(), this::scene,
                RenderOptions.DEFAULT, progress, (number, cache, _) -> {
                    ImageFile.write(folder.resolve(file(name, number)), cache.film(), view);
                    listener.accept(number + 1);
                });
    }
}
