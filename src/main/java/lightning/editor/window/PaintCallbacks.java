package lightning.editor.window;

import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;

/** Goes on when a window was drawn. */
final class PaintCallbacks {
    /** The first is told before what is there is drawn, the second while it is, the third after it. */
    private static final int PULSES = 3;

    private PaintCallbacks() {}

    /** With all that is in it now: what comes next takes the window's thread and all processors for a while. */
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
     * With something that may not be there yet.
     *
     * @param isReady    whether it is
     * @param timeoutNs how long that is waited for, nanoseconds
     */
    static void afterPaintOf(BooleanSupplier isReady, long timeoutNs, Runnable callback) {
        new AnimationTimer() {
            private long since;
            private boolean drawn;

            @Override
            public void handle(long now) {
                since = since == 0 ? now : since;
                if (drawn || now - since > timeoutNs) {
                    stop();
                    Platform.runLater(callback);
                }
                // It is drawn after this.
                drawn = isReady.getAsBoolean();
            }
        }.start();
    }
}
