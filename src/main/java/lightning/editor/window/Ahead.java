package lightning.editor.window;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.PauseTransition;
import javafx.event.EventHandler;
import javafx.scene.Scene;
import javafx.scene.input.InputEvent;
import javafx.util.Duration;
import lightning.editor.window.widget.Slices;

/** Makes what will be opened while nobody works: one step after the other, and none while there is anything else to do. */
final class Ahead implements AutoCloseable {
    private static final Duration BETWEEN = Duration.millis(100);
    /** Nobody works who did nothing for so long, nanoseconds. */
    private static final long REST_NS = 1_000_000_000;

    private final Scene scene;
    private final BooleanSupplier resting;
    private final Iterator<Runnable> steps;
    private final PauseTransition pause = new PauseTransition(BETWEEN);
    private final EventHandler<InputEvent> hand = _ -> touched = System.nanoTime();
    private long touched = System.nanoTime();

    /**
     * Begins with the first step as soon as that can be.
     *
     * @param scene   of the window that somebody works at
     * @param resting whether nothing is being done beside the window
     */
    Ahead(Scene scene, BooleanSupplier resting, Iterator<Runnable> steps) {
        this.scene = scene;
        this.resting = resting;
        this.steps = steps;
        scene.addEventFilter(InputEvent.ANY, hand);
        pause.setOnFinished(_ -> look());
        pause.play();
    }

    private void look() {
        // What comes in slices has the thread for itself.
        if (System.nanoTime() - touched > REST_NS && resting.getAsBoolean() && !Slices.isAnyGoing()) {
            steps.next().run();
        }
        if (steps.hasNext()) {
            pause.playFromStart();
        } else {
            close();
        }
    }

    @Override
    public void close() {
        pause.stop();
        scene.removeEventFilter(InputEvent.ANY, hand);
    }
}
