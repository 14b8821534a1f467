package lightning.editor.window;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.PauseTransition;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.InputEvent;
import javafx.util.Duration;
import lightning.editor.window.widget.TimeSlicedTask;

/** Makes what will be opened while nobody works: one step after the other, and none while there is anything else to do. */
final class IdlePreloader implements AutoCloseable {
    private static final Duration STEP_INTERVAL = Duration.millis(100);
    /** Nobody works who did nothing for so long, nanoseconds. */
    private static final long IDLE_NS = 1_000_000_000;

    private final Scene scene;
    private final BooleanSupplier isIdle;
    private final Iterator<Runnable> steps;
    private final PauseTransition stepTimer = new PauseTransition(STEP_INTERVAL);
    private final EventHandler<InputEvent> inputListener = _ -> lastInputNs = System.nanoTime();
    private long lastInputNs = System.nanoTime();

    /**
     * Begins with the first step as soon as that can be.
     *
     * @param scene   of the window that somebody works at
     * @param isIdle whether nothing is being done beside the window
     */
    IdlePreloader(Scene scene, BooleanSupplier isIdle, Iterator<Runnable> steps) {
        this.scene = scene;
        this.isIdle = isIdle;
        this.steps = steps;
        scene.addEventFilter(InputEvent.ANY, inputListener);
        stepTimer.setOnFinished(_ -> runNextStep());
        stepTimer.play();
    }

    private void runNextStep() {
        // What comes in slices has the thread for itself.
        if (System.nanoTime() - lastInputNs > IDLE_NS && isIdle.getAsBoolean() && !TimeSlicedTask.isAnyRunning()) {
            steps.next().run();
        }
        if (steps.hasNext()) {
            stepTimer.playFromStart();
        } else {
            close();
        }
    }

    @Override
    public void close() {
        stepTimer.stop();
        scene.removeEventFilter(InputEvent.ANY, inputListener);
    }
}
