package lightning.editor.window;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.PauseTransition;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.InputEvent;
import javafx.util.Duration;
import lightning.editor.window.widget.TimeSlicedTask;

/** Creates panels in the background while the user is idle. Runs one step at a time, and none while other work is running. */
final class IdlePreloader implements AutoCloseable {
    private static final Duration STEP_INTERVAL = Duration.millis(100);
    /** Time without input after which the user counts as idle, nanoseconds. */
    private static final long IDLE_NS = 1_000_000_000;

    private final Scene scene;
    private final BooleanSupplier isIdle;
    private final Iterator<Runnable> steps;
    private final PauseTransition stepTimer = new PauseTransition(STEP_INTERVAL);
    private final EventHandler<InputEvent> inputListener = _ -> lastInputNs = System.nanoTime();
    private long lastInputNs = System.nanoTime();

    /**
     * Starts the first step as soon as the user is idle.
     *
     * @param scene scene of the window whose input events count
     * @param isIdle returns true if no background work is running
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
        // Time-sliced tasks have the thread to themselves.
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
