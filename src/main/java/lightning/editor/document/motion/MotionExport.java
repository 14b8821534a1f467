package lightning.editor.document.motion;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.image.ImageFile;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.warmup.DelayedWarmUp;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/**
 * Writes a recorded shot as numbered pictures, evenly spaced from its begin to its end. Each is exact, its mirrors too.
 *
 * @param scene    all but the moving light
 * @param recordedShot of a light of the scene
 * @param pictureCount how many, 1…{@value #MAX_PICTURES}
 * @param view     how linear light becomes display pixels
 */
public record MotionExport(Scene scene, RecordedShot recordedShot, int pictureCount, ViewTransform view) {
    public static final int MAX_PICTURES = 100_000;
    private static final int MIN_DIGITS = 4;

    public MotionExport {
        SceneLimits.checkRange("the number of pictures", pictureCount, 1, MAX_PICTURES);
        recordedShot.shot().check(scene);
    }

    /** Hears how far the export is, and stops it. On the thread that exports. */
    public interface Listener {
        /** So many pictures are written. */
        void pictureWritten(int pictures);

        /** Asked often. */
        boolean isCanceled();
    }

    /** The scene of one picture, 0 ≤ {@code number} &lt; {@link #pictureCount}. */
    public Scene scene(int number) {
        double share = pictureCount == 1 ? 0 : (double) number / (pictureCount - 1);
        return recordedShot.shot().sceneAt(scene, share * recordedShot.shot().last());
    }

    /** The name of one picture's file: {@code name-0001.png} for the first. */
    public String file(String name, int number) {
        int digits = Math.max(MIN_DIGITS, Integer.toString(pictureCount).length());
        return name + "-" + String.format(Locale.ROOT, "%0" + digits + "d", number + 1) + ".png";
    }

    /**
     * Renders and writes all pictures; waits until they are there.
     *
     * @param name what the files are called before their number
     * @throws IOException           if one cannot be written; those before it stay
     * @throws CancellationException if the listener asked for it; the pictures that are finished stay
     */
    public void write(Path folder, String name, Listener listener) throws IOException {
        Progress cancellation = Progress.cancellation(listener::isCanceled);
        try (var _ = new DelayedWarmUp(scene(0));
                var renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT))) {
            for (int i = 0; i < pictureCount; i++) {
                renderer.render(scene(i), cancellation);
                ImageFile.write(folder.resolve(file(name, i)), renderer.film(), view);
                listener.pictureWritten(i + 1);
            }
        }
    }
}
