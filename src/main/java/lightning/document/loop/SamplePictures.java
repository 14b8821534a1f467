package lightning.document.loop;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;

/** Pictures of small scenes, rendered in the background in a studio with soft walls, and kept in memory. */
public final class SamplePictures {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 32;

    private static final ThreadFactory THREADS = DedicatedThread.lowPriorityFactory("lightning-samples");

    private final Map<String, SamplePicture> pictures = new ConcurrentHashMap<>();

    /**
     * Finished picture.
     *
     * @param width pixels
     * @param height pixels
     * @param pixels {@code int[width * height]}, opaque 0xFFRRGGBB
     */
    public record SamplePicture(int width, int height, int[] pixels) {
        // Immutable by convention: the array is written only before construction.
    }

    /**
     * Requests pictures. Those that exist already are not rendered again.
     *
     * @param scenes scene of each name, in the order of rendering
     * @param onPicture receives each picture, on the rendering thread
     * @return stops the rendering
     */
    public Runnable request(Map<String, Scene> scenes, BiConsumer<String, SamplePicture> onPicture) {
        var isCanceled = new AtomicBoolean();
        THREADS.newThread(() -> {
            try {
                for (Map.Entry<String, Scene> entry : scenes.entrySet()) {
                    SamplePicture picture = pictures.get(entry.getKey());
                    if (picture == null) {
                        picture = render(entry.getValue(), Progress.cancellation(isCanceled::get));
                        pictures.put(entry.getKey(), picture);
                    }
                    onPicture.accept(entry.getKey(), picture);
                }
            } catch (CancellationException | OutOfMemoryError e) {
                // The places of the other pictures stay empty.
            }
        }).start();
        return () -> isCanceled.set(true);
    }

    /** Renders a scene in the studio. */
    public static SamplePicture render(Scene scene, Progress progress) {
        // One thread leaves the others to the pictures of the user.
        try (var workers = new WorkerPool(1)) {
            Film film = new TraditionalTracer(inStudio(scene)).trace(workers, progress).film();
            return new SamplePicture(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
        }
    }

    /** Returns a scene with the studio around it. */
    public static Scene inStudio(Scene scene) {
        return scene.withWorld(studio(scene.world()));
    }

    /** Returns a world of gray walls, brighter above, with two bright panels that reflections show. */
    private static World studio(World world) {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                boolean isPanel = y > 6 && y < 15 && (x > 6 && x < 14 || x > 48 && x < 53);
                double wall = 0.12 + 0.4 * Math.max(0, 1 - 2.0 * y / HEIGHT);
                double gray = isPanel ? 1.6 : wall;
                int at = 3 * (y * WIDTH + x);
                rgb[at] = (float) (gray * 0.98);
                rgb[at + 1] = (float) gray;
                rgb[at + 2] = (float) (gray * 1.04);
            }
        }
        return world.withEnvironment(Optional.of(new Environment("studio", new EnvironmentMap(WIDTH, HEIGHT, rgb))));
    }
}
