package lightning.edit;

import java.util.function.Consumer;
import lightning.accuracy.Verification;
import lightning.accuracy.WarmSaving;
import lightning.edit.loop.Frame;
import lightning.edit.loop.RenderListener;
import lightning.image.Film;
import lightning.relight.plan.UpdatePlan;
import lightning.scene.Scene;

/**
 * Tells the canvas what the render loop does, on the loop's own threads, and then the workbench, on the thread that that
 * belongs to.
 *
 * @param tell      brings a task to the workbench's thread
 * @param finished  takes a finished picture there
 * @param dropped   takes there that there is no picture any more
 * @param settled   looks there again at what is in work
 */
public record WorkbenchEar(RenderListener canvas, Consumer<Runnable> tell, Consumer<Frame> finished, Runnable dropped,
        Runnable settled) implements RenderListener {

    @Override
    public void started(UpdatePlan plan) {
        canvas.started(plan);
    }

    @Override
    public void progress(int done, int total) {
        canvas.progress(done, total);
    }

    @Override
    public void verifying(int done, int total) {
        canvas.verifying(done, total);
    }

    @Override
    public void coarse(Film film, Scene scene) {
        canvas.coarse(film, scene);
    }

    @Override
    public void rendered(Frame frame) {
        canvas.rendered(frame);
        tell.accept(() -> finished.accept(frame));
    }

    @Override
    public void forgotten() {
        canvas.forgotten();
        tell.accept(dropped);
    }

    @Override
    public void measured(WarmSaving saving) {
        canvas.measured(saving);
    }

    @Override
    public void verified(Verification verification) {
        canvas.verified(verification);
        tell.accept(settled);
    }

    @Override
    public void cancelled() {
        canvas.cancelled();
        tell.accept(settled);
    }

    @Override
    public void failed(Throwable problem) {
        canvas.failed(problem);
        tell.accept(settled);
    }

    @Override
    public void idle() {
        canvas.idle();
        // More work may have come since.
        tell.accept(settled);
    }
}
