package lightning.editor.window;

import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;

/** Runs callbacks after a window has been painted. */
final class PaintCallbacks {
    /** Number of pulses to wait: before, during and after painting the current content. */
    private static final int PULSES = 3;

    private PaintCallbacks() {}

    /** Runs the callback after the current content is painted. The callback may then block the window's thread and use all processors. */
    static void afterNextPaint(Runnable callback) {
        new AnimationTimer() {
            private int pulses;

            @Override
            public void handle(long now) {
                if (++pulses == PULSES) {
                    stop();
                    callback.run();
                }
            }
        }.start();
    }

    /**
     * Runs the callback after content has been painted that may not be ready yet.
     *
     * @param isReady returns true once the content is ready
     * @param timeoutNs maximum wait, nanoseconds
     */
    static void afterPaintOf(BooleanSupplier isReady, long timeoutNs, Runnable callback) {
        new AnimationTimer() {
            private long startTime;
            private boolean drawn;

            @Override
            public void handle(long now) {
                startTime = startTime == 0 ? now : startTime;
                if (drawn || now - startTime > timeoutNs) {
                    stop();
                    Platform.runLater(callback);
                }
                // The content is painted after this pulse.
                drawn = isReady.getAsBoolean();
            }
        }.start();
    }
}
