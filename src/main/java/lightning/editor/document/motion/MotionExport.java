package lightning.editor.document.motion;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.format.picture.PictureFile;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.render.warmup.LateWarmUp;
import lightning.scene.Limits;
import lightning.scene.Scene;

/**
 * Writes a recorded shot as numbered pictures, evenly spaced from its begin to its end. Each is exact, its mirrors too.
 *
 * @param scene    all but the moving light
 * @param recorded of a light of the scene
 * @param pictures how many, 1…{@value #MAX_PICTURES}
 * @param view     how linear light becomes display pixels
 */
public record MotionExport(Scene scene, RecordedShot recorded, int pictures, ViewTransform view) {
    public static final int MAX_PICTURES = 100_000;
    private static final int LEAST_DIGITS = 4;

    public MotionExport {
        Limits.range("the number of pictures", pictures, 1, MAX_PICTURES);
        recorded.shot().check(scene);
    }

    /** Hears how far the export is, and stops it. On the thread that exports. */
    public interface Listener {
        /** So many pictures are written. */
        void written(int pictures);

        /** Asked often. */
        boolean isCancelled();
    }

    /** The scene of one picture, 0 ≤ {@code number} &lt; {@link #pictures}. */
    public Scene scene(int number) {
        double share = pictures == 1 ? 0 : (double) number / (pictures - 1);
        return recorded.shot().at(scene, share * recorded.shot().last());
    }

    /** The name of one picture's file: {@code name-0001.png} for the first. */
    public String file(String name, int number) {
        int digits = Math.max(LEAST_DIGITS, Integer.toString(pictures).length());
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
        Progress stop = Progress.until(listener::isCancelled);
        try (var _ = new LateWarmUp(scene(0)); var renderer = new Renderer(Options.DEFAULT.withReflections(Reflections.CURRENT))) {
            for (int i = 0; i < pictures; i++) {
                renderer.render(scene(i), stop);
                PictureFile.write(folder.resolve(file(name, i)), renderer.film(), view);
                listener.written(i + 1);
            }
        }
    }
}
