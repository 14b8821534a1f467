package lightning.editor.window.widget;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.scene.Node;
import javafx.stage.Window;

/** Task that runs in small steps on the window's thread, as many per pulse as fit a time budget. */
public final class TimeSlicedTask {
    /** Time budget per pulse, nanoseconds. Shorter than a pulse, so that animation continues; a longer step runs alone. */
    private static final long SLICE_NS = 10_000_000;

    private static int runningCount;

    private final BooleanSupplier nextPart;
    private boolean isRunning;
    private final AnimationTimer timer = new AnimationTimer() {
        @Override
        public void handle(long now) {
            if (!runSlice()) {
                cancel();
            }
        }
    };

    /** @param nextPart  runs the next step; returns false if there was none */
    public TimeSlicedTask(BooleanSupplier nextPart) {
        this.nextPart = nextPart;
    }

    /** Runs all steps once, pausing while the window of the pane is closed. */
    public static void whileVisible(Node pane, Iterator<Runnable> parts) {
        var task = new TimeSlicedTask(() -> {
            if (parts.hasNext()) {
                parts.next().run();
            }
            return parts.hasNext();
        });
        VisibilityListener.attach(pane, () -> {
            task.start();
            return task::cancel;
        });
    }

    /** Runs the first steps immediately and the rest in the following pulses. */
    public void start() {
        cancel();
        if (runSlice()) {
            isRunning = true;
            runningCount++;
            timer.start();
        }
    }

    /** Stops the task. Remaining steps do not run. */
    public void cancel() {
        timer.stop();
        if (isRunning) {
            isRunning = false;
            runningCount--;
        }
    }

    /** Returns whether any task waits for the next pulse. */
    public static boolean isAnyRunning() {
        return runningCount > 0;
    }

    /** Applies a node's style within the current slice, if its window is already showing. */
    public static void applyStyle(Node node) {
        if (node.getScene() != null && Window.getWindows().contains(node.getScene().getWindow())) {
            node.applyCss();
        }
    }

    private boolean runSlice() {
        long startNs = System.nanoTime();
        long now = startNs;
        long last;
        do {
            last = now;
            if (!nextPart.getAsBoolean()) {
                return false;
            }
            now = System.nanoTime();
            // Assumes that the next step takes as long as the last.
        } while (now + (now - last) < startNs + SLICE_NS);
        return true;
    }
}
