package lightning.document.loop;

import java.io.IOException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import lightning.base.work.DedicatedThread;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Restores the kept picture of a document before its first pass, and keeps pictures that took long. Confined to the loop's thread; files are
 * written on a thread of low priority.
 */
final class PictureKeeper implements AutoCloseable {
    private static final long CLOSE_TIMEOUT_SECONDS = 20;

    private final KeptPictures kept;
    private final ExecutorService writer = DedicatedThread.lowPriorityExecutor("lightning-keep");
    private boolean isOpened;
    private boolean isRestored;
    /** Time at which the document's first pass began. */
    private long start;

    PictureKeeper(KeptPictures kept) {
        this.kept = kept;
    }

    /** Begins with another document. */
    void open() {
        isOpened = false;
        isRestored = false;
    }

    /**
     * Restores the picture of a document's first scene, if it was kept.
     *
     * @param beforeReading called before its file is read, which takes a processor for a second
     */
    void restore(Scene scene, Renderer renderer, Runnable beforeReading) {
        if (!isOpened && !renderer.state().hasPicture() && isDefault(renderer.options())) {
            start = System.nanoTime();
            kept.find(renderer.options().view().apply(scene), shown -> {
                beforeReading.run();
                return renderer.prepare(shown);
            }, renderer.options().memory()).ifPresent(cache -> {
                renderer.restore(cache);
                isRestored = true;
            });
        }
    }

    /** Notes that a scene was rendered. Returns whether it is the document's first, and its picture was not restored. */
    boolean isNew() {
        boolean isFirst = !isOpened;
        isOpened = true;
        return isFirst && !isRestored;
    }

    private static boolean isDefault(RenderOptions options) {
        return options.equals(options.withDefaultMethod()) && options.view().equals(ViewEffects.ALL);
    }

    /** Keeps the renderer's picture, if it is finished and took long when it was traced first. */
    void keep(Renderer renderer) {
        boolean isLong = isRestored || System.nanoTime() - start > kept.longNs();
        if (isLong && isDefault(renderer.options()) && renderer.state().isFinished() && renderer.state().hasPicture()) {
            PixelCache cache = renderer.cache();
            writer.execute(() -> write(cache));
        }
    }

    private void write(PixelCache cache) {
        try {
            kept.keep(cache);
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            // Then the scene is traced again.
        }
    }

    /** Finishes files that are being written, unless the disk is very slow. */
    @Override
    public void close() {
        writer.shutdown();
        try {
            writer.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
