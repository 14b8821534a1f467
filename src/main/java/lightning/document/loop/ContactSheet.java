package lightning.document.loop;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.SceneView;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Small exact pictures of several scenes, rendered in the background, one after the other. Each scene keeps what was learned for its last picture, so
 * an edit recomputes only its changes. A picture of a quarter of the size comes first where there is none yet.
 */
public final class ContactSheet implements AutoCloseable {
    private static final int COARSE = 4;

    private final int maxWidth;
    private final int maxHeight;
    private final BiConsumer<Integer, SheetPicture> onPicture;
    private final BiConsumer<Integer, Throwable> onFailure;
    private final ExecutorService thread = DedicatedThread.lowPriorityExecutor("lightning-sheet");
    private final AtomicReference<List<Supplier<Scene>>> newest = new AtomicReference<>(List.of());
    private final Map<Integer, Renderer> renderers = new HashMap<>();
    private final Map<Integer, Scene> shown = new HashMap<>();
    /** Scene to begin with: the one that the last request did not reach. */
    private int next;

    /**
     * Finished picture.
     *
     * @param pixels  {@code int[width * height]}, opaque 0xFFRRGGBB
     * @param isExact false for a coarse picture
     */
    public record SheetPicture(int width, int height, int[] pixels, boolean isExact) {
        // Immutable by convention: the array is written only before construction.
    }

    /**
     * Creates an instance without pictures.
     *
     * @param maxWidth  largest width of a picture, pixels
     * @param maxHeight largest height of a picture, pixels
     * @param onPicture receives the index of a scene and its picture, on the rendering thread
     * @param onFailure receives the index of a scene that has none, and the reason, on the rendering thread
     */
    public ContactSheet(int maxWidth, int maxHeight, BiConsumer<Integer, SheetPicture> onPicture,
            BiConsumer<Integer, Throwable> onFailure) {
        this.maxWidth = maxWidth;
        this.maxHeight = maxHeight;
        this.onPicture = onPicture;
        this.onFailure = onFailure;
    }

    /**
     * Shows scenes in place of those before. The same index is taken for the same scene with edits.
     *
     * @param scenes called on the rendering thread; may throw an {@link IllegalArgumentException} with the reason why there is no scene
     */
    public void show(List<Supplier<Scene>> scenes) {
        List<Supplier<Scene>> request = new ArrayList<>(scenes);
        newest.set(request);
        try {
            thread.execute(() -> run(request));
        } catch (RejectedExecutionException e) {
            // Closed meanwhile.
        }
    }

    private void run(List<Supplier<Scene>> request) {
        Progress progress = Progress.cancellation(() -> newest.get() != request);
        int first = next;
        try {
            for (int i = 0; i < request.size(); i++) {
                if (!shown.containsKey(i)) {
                    render(i, request.get(i), COARSE, progress);
                }
            }
            for (int k = 0; k < request.size(); k++) {
                next = (first + k) % request.size();
                render(next, request.get(next), 1, progress);
            }
            next = 0;
        } catch (CancellationException e) {
            // The next request begins where this one stopped.
        }
    }

    private void render(int index, Supplier<Scene> supplier, int shrink, Progress progress) {
        if (progress.isCanceled()) {
            throw new CancellationException();
        }
        try {
            Scene scene = fitted(supplier.get(), shrink);
            if (shrink > 1) {
                try (var coarse = new Renderer(options())) {
                    report(index, coarse, scene, progress, false);
                }
            } else if (!scene.equals(shown.get(index))) {
                report(index, renderers.computeIfAbsent(index, _ -> new Renderer(options())), scene, progress, true);
                shown.put(index, scene);
            }
        } catch (CancellationException e) {
            throw e;
        } catch (RuntimeException | OutOfMemoryError e) {
            onFailure.accept(index, e);
        }
    }

    private void report(int index, Renderer renderer, Scene scene, Progress progress, boolean isExact) {
        renderer.render(scene, progress);
        Film film = renderer.film();
        onPicture.accept(index, new SheetPicture(film.width(), film.height(), SceneView.of(scene).toPixels(film), isExact));
    }

    /** Leaves a processor to the picture of the editor. */
    private static RenderOptions options() {
        return RenderOptions.DEFAULT.withThreads(1);
    }

    private Scene fitted(Scene scene, int shrink) {
        PictureSettings picture = scene.picture();
        double factor =
                Math.min(1, Math.min((double) maxWidth / picture.width(), (double) maxHeight / picture.height())) / shrink;
        return scene.withPicture(picture.withSize((int) Math.max(1, Math.round(picture.width() * factor)),
                (int) Math.max(1, Math.round(picture.height() * factor))));
    }

    /** Stops rendering and forgets all pictures. */
    @Override
    public void close() {
        newest.set(List.of());
        try {
            thread.execute(() -> {
                renderers.values().forEach(Renderer::close);
                renderers.clear();
                shown.clear();
            });
        } catch (RejectedExecutionException e) {
            // Closed before.
        }
        thread.shutdown();
    }
}
