package lightning.document.loop;

import lightning.render.image.Film;
import lightning.render.measure.Verification;
import lightning.render.measure.WarmSaving;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Listener for events of a {@link RenderLoop}, called on the loop's threads. Implementations must return quickly and must not wait for the
 * loop. Convert films to pixels here, as this does not block a window.
 */
public interface RenderListener {
    /** Called when an update starts. */
    default void started(UpdatePlan plan) {}

    /** Called when the indirect light of an image starts that shows direct light so far. Its progress follows. */
    default void indirectStarted() {}

    /** Called when the finer samples of an image start. Their progress follows. */
    default void samplesStarted() {}

    /** Reports rays that were cast since the last report. Called on any thread. */
    default void raysCast(long count) {}

    /** Reports that {@code done} of {@code total} tiles of the update are finished. Called on any thread. */
    default void progress(int done, int total) {}

    /** Reports that {@code done} of {@code total} tiles of a verification are finished. Called on any thread. */
    default void verificationProgress(int done, int total) {}

    /** Receives a coarse image of a scene in its first pass or a slow update, to show enlarged until the final one is finished. */
    default void coarseRendered(Film film, Scene scene) {}

    /**
     * Receives a finished tile of a scene in its first pass or a slow update. Called on any thread.
     *
     * @param film red, green and blue of the tile, each {@code float[1024]}
     */
    default void tileRendered(Scene scene, int tile, float[][] film) {}

    /** Receives a finished image, or another view of it. {@link #workRemaining} or {@link #idle} follows immediately. */
    default void rendered(Frame frame) {}

    /** Reports that the last image was dropped. All later events belong to the document of {@code number}: see {@link RenderLoop#open}. */
    default void pictureDropped(long number) {}

    /** Receives the measured saving of the last update, or of an older one if a newer one was made meanwhile. */
    default void savingMeasured(WarmSaving saving) {}

    /** Receives the comparison of the last image with a full trace. */
    default void verified(Verification verification) {}

    /** Called when a job was canceled, or replaced by a newer one. */
    default void canceled() {}

    /** Called when a job failed; the last image stays. Causes are lack of memory or an internal error. */
    default void failed(Throwable problem) {}

    /** Called when a job ended and more are pending. */
    default void workRemaining() {}

    /** Called when no job is left. */
    default void idle() {}
}
