package lightning.document.loop;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Future;
import lightning.base.work.DedicatedThread;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;

/**
 * Render loop of the editor (Go, Live, Update Reflections and Verify) on its own thread. Always renders the newest requested scene. All
 * methods return immediately and may be called from any thread.
 *
 * <pre>{@code
 * RenderLoop loop = new RenderLoop(RenderOptions.DEFAULT, listener);
 * loop.render(document.scene());      // Go
 * loop.updateReflections();
 * }</pre>
 */
public final class RenderLoop implements AutoCloseable {
    private static final long CLOSE_TIMEOUT_MS = 30_000;

    private final RenderQueue queue = new RenderQueue(Duration.ofMillis(250));
    private final PictureVerifier verifier;
    private final RenderWorker worker;
    private final Thread thread;

    /** Starts the thread, for scenes whose pictures are not kept. Renders nothing until a scene is requested. */
    public RenderLoop(RenderOptions options, RenderListener listener) {
        this(options, listener, KeptPictures.none());
    }

    /**
     * Starts the thread. Renders nothing until a scene is requested.
     *
     * @param kept pictures of earlier processes, for the first scene of each document
     */
    public RenderLoop(RenderOptions options, RenderListener listener, KeptPictures kept) {
        this(options, listener, kept, PathTimes.SLOW_SECONDS);
    }

    /** @param slowPaths time of paths of indirect light from which a picture with direct light is shown first, in seconds */
    RenderLoop(RenderOptions options, RenderListener listener, double slowPaths) {
        this(options, listener, KeptPictures.none(), slowPaths);
    }

    private RenderLoop(RenderOptions options, RenderListener listener, KeptPictures kept, double slowPaths) {
        verifier = new PictureVerifier(options.threads(), listener);
        worker = new RenderWorker(options, queue, verifier, listener, new PathTimes(slowPaths), kept);
        thread = DedicatedThread.create("lightning-render", new RenderJobRunner(queue, worker, listener));
        thread.start();
    }

    /**
     * Sets a startup preview of the first scene, rendered elsewhere. Call it before the first request. The loop reports its failures.
     *
     * @param menusShown event after which the loop begins to trace the scene, since tracing and its compilation would take the processors from it
     */
    public void setStartupPreview(Future<Optional<CoarsePicture>> preview, Future<?> menusShown) {
        worker.setStartupPreview(preview, menusShown);
    }

    /**
     * Renders a scene and replaces a pending one. Cancels a first pass of another image (size, camera, shapes). Finishes a running update
     * first, so that images appear even during continuous edits.
     */
    public void render(Scene scene) {
        queue.render(scene);
    }

    /** Updates reflections to the scene rendered last, after a pending scene. Does nothing before the first image. */
    public void updateReflections() {
        queue.requestReflections();
    }

    /** Verifies the scene rendered last with a full trace, concurrently with other work. Does nothing before the first image. */
    public void verify() {
        queue.requestVerification();
    }

    /** Keeps the picture of the scene rendered last for later processes, after pending work, if tracing it again would take long. */
    public void keepPicture() {
        queue.requestKeeping();
    }

    /** Changes the options. Keeps the cache as far as possible: see {@link Renderer#setOptions}. */
    public void changeOptions(RenderOptions options) {
        queue.changeOptions(options);
    }

    /** Changes the options and renders another scene. */
    public void changeOptions(RenderOptions options, Scene scene) {
        queue.changeOptions(options, scene);
    }

    /** Sets the view transform, as {@link Renderer#setView}; effective from the next update. */
    public void setView(ViewTransform v) {
        worker.setView(v);
    }

    /** Changes the display mode; the image itself does not change. */
    public void setDisplayMode(DisplayMode v) {
        worker.setDisplayMode(v);
        queue.requestRedisplay();
    }

    /**
     * Cancels running jobs, verifications included, and drops pending ones. The last image stays.
     *
     * @return true if a scene was pending; the listener does not receive its cancellation, as it did not start
     */
    public boolean cancel() {
        boolean wasWaiting = queue.cancel();
        verifier.cancel();
        return wasWaiting;
    }

    /**
     * Stops all work, drops the cache and renders the scene of another document.
     *
     * @param number reported when the cache is dropped; larger than that of the previous document
     */
    public void open(Scene scene, long number) {
        queue.open(scene, number);
        verifier.cancel();
    }

    /**
     * Returns the cache of the last reported image; empty if none exists or it was freed. It is immutable and safe to read on any thread,
     * but large: do not hold it for long.
     */
    public Optional<PixelCache> cache() {
        return worker.cache();
    }

    /** Returns whether a render is running or pending. A verification does not count. */
    public boolean isBusy() {
        return queue.isBusy();
    }

    /** Returns whether a verification is running or pending. */
    public boolean isVerifying() {
        return queue.isVerifying() || verifier.isBusy();
    }

    /** Returns whether the loop's thread is running, that is, not closed. */
    boolean isAlive() {
        return thread.isAlive();
    }

    /** Stops all work and waits for the threads to end. */
    @Override
    public void close() {
        queue.close();
        verifier.close();
        try {
            thread.join(CLOSE_TIMEOUT_MS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
