package lightning.editor.window.widget;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.scene.Node;
import javafx.stage.Window;

/** Work of many small parts on the window's thread: in each pulse as many as leave the thread to all else that it has to do. */
public final class TimeSlicedTask {
    /** Less than a pulse, so that the picture goes on; a part that takes longer is alone in its pulse. */
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

    /** @param nextPart does the next part; returns whether there was one */
    public TimeSlicedTask(BooleanSupplier nextPart) {
        this.nextPart = nextPart;
    }

    /** Does all parts once, as far as it comes each time that a pane is seen. */
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

    /** Does the first parts at once, and goes on in the pulses that follow until there is none left. */
    public void start() {
        cancel();
        if (runSlice()) {
            isRunning = true;
            runningCount++;
            timer.start();
        }
    }

    /** Leaves what is not done. */
    public void cancel() {
        timer.stop();
        if (isRunning) {
            isRunning = false;
            runningCount--;
        }
    }

    /** Whether any work waits for the next pulse. */
    public static boolean isAnyRunning() {
        return runningCount > 0;
    }

    /** A node takes on its looks at once, in this slice, where what is around it has its own: not while its window is about to open. */
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
            // What comes next may take as long as the last.
        } while (now + (now - last) < startNs + SLICE_NS);
        return true;
    }
}
