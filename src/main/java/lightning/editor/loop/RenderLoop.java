package lightning.editor.loop;

import java.util.Optional;
import java.util.concurrent.Future;
import lightning.base.work.DedicatedThread;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;

/**
 * Renders on a thread of its own, the newest wanted scene each time: Go, Live, Update Reflections and Verify of the
 * editor. All methods return at once and may be called from any thread.
 *
 * <pre>{@code
 * RenderLoop loop = new RenderLoop(RenderOptions.DEFAULT, listener);
 * loop.render(document.scene());      // Go
 * loop.updateReflections();
 * }</pre>
 */
public final class RenderLoop implements AutoCloseable {
    private static final long CLOSE_TIMEOUT_MS = 10_000;

    private final RenderQueue queue = new RenderQueue();
    private final PictureVerifier verifier;
    private final RenderWorker worker;
    private final Thread thread;

    /** Starts the thread; nothing is rendered until a scene is wanted. */
    public RenderLoop(RenderOptions options, RenderListener listener) {
        verifier = new PictureVerifier(options.threads(), listener);
        worker = new RenderWorker(options, queue, verifier, listener);
        thread = DedicatedThread.create("lightning-render", new RenderJobRunner(queue, worker, listener));
        thread.start();
    }

    /** Before the first scene is wanted: how that is looked at first, by somebody else. Whatever goes wrong with it is the loop's to tell. */
    public void setStartupPreview(Future<Optional<CoarsePicture>> preview) {
        worker.setStartupPreview(preview);
    }

    /**
     * Brings the picture to a scene. Replaces a scene that still waits. A trace of another picture (size, camera, shapes) is
     * canceled; an update that runs is finished first, so that a picture comes even while edits never pause.
     */
    public void render(Scene scene) {
        queue.render(scene);
    }

    /** Makes the mirrors show the scene rendered last, after a scene that waits. Nothing happens before a first picture. */
    public void updateReflections() {
        queue.requestReflections();
    }

    /** Traces the scene rendered last in full, beside all other work, and compares. Nothing happens before a first picture. */
    public void verify() {
        queue.requestVerification();
    }

    /** Another way of working. What is known of the picture serves on as far as it can: see {@link Renderer#setOptions}. */
    public void changeOptions(RenderOptions options) {
        queue.changeOptions(options);
    }

    /** Another way of working, and another scene. */
    public void changeOptions(RenderOptions options, Scene scene) {
        queue.changeOptions(options, scene);
    }

    /** See {@link Renderer#setView}; counts from the next update. */
    public void setView(ViewTransform v) {
        worker.setView(v);
    }

    /** Shows the picture in another way; nothing of it changes. */
    public void setDisplayMode(DisplayMode v) {
        worker.setDisplayMode(v);
        queue.requestRedisplay();
    }

    /**
     * Stops what runs, a verification too, and forgets what waits. The last picture stays.
     *
     * @return whether a scene waited: the listener does not hear that it is canceled, since it was not begun
     */
    public boolean cancel() {
        boolean wasWaiting = queue.cancel();
        verifier.cancel();
        return wasWaiting;
    }

    /**
     * Stops everything, drops all that is known of the picture, and renders another document's scene.
     *
     * @param number told when all was dropped; larger than that of the document before
     */
    public void open(Scene scene, long number) {
        queue.open(scene, number);
        verifier.cancel();
    }

    /**
     * What is kept of the picture that was told of last; empty where there is none, or it was let go of. It is never written over
     * and may be read on any thread, but holds much memory: it is to be let go of soon.
     */
    public Optional<PixelCache> cache() {
        return worker.cache();
    }

    /** Whether the picture is being worked at. A verification runs beside and does not count. */
    public boolean isBusy() {
        return queue.isBusy();
    }

    /** Whether a verification runs or waits. */
    public boolean isVerifying() {
        return queue.isVerifying() || verifier.isBusy();
    }

    /** Whether its thread still runs: until it is closed. */
    boolean isAlive() {
        return thread.isAlive();
    }

    /** Stops everything and waits for the threads to end. */
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
