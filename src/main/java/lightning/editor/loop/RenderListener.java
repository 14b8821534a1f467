package lightning.editor.loop;

import lightning.bench.accuracy.Verification;
import lightning.bench.accuracy.WarmSaving;
import lightning.render.image.Film;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Hears what a {@link RenderLoop} does, on the loop's own threads: it must hand over quickly and must not wait for the
 * loop. Turning a film into pixels is best done here, where it does not hold up a window.
 */
public interface RenderListener {
    /** An update begins. */
    default void started(UpdatePlan plan) {}

    /** {@code done} of {@code total} tiles of the update are finished. From any thread. */
    default void progress(int done, int total) {}

    /** {@code done} of {@code total} tiles of a verification are finished. From any thread. */
    default void verificationProgress(int done, int total) {}

    /** A small picture of the scene that is being traced for the first time, to show enlarged until it is there. */
    default void coarseRendered(Film film, Scene scene) {}

    /**
     * A tile of the scene that is being traced for the first time is there. From any thread.
     *
     * @param film its red, green and blue, each {@code float[1024]}
     */
    default void tileRendered(Scene scene, int tile, float[][] film) {}

    /** A picture is finished, or another look at it. Whether more is to be done is told right after: {@link #workRemaining} or {@link #idle}. */
    default void rendered(Frame frame) {}

    /** The last picture is dropped: see {@link RenderLoop#open}, of whose {@code number} all is that is told after this. */
    default void pictureDropped(long number) {}

    /** It was found out what an update saves: the last one, unless a newer one was made meanwhile. */
    default void savingMeasured(WarmSaving saving) {}

    /** A full trace was compared with the last picture. */
    default void verified(Verification verification) {}

    /** A work ended before its time, because it was canceled or newer work made it useless. */
    default void canceled() {}

    /** A work failed; the last picture stays. Memory may have run out, anything else is an error of the program. */
    default void failed(Throwable problem) {}

    /** A work is over, and more waits. */
    default void workRemaining() {}

    /** Nothing is left to do. */
    default void idle() {}
}
