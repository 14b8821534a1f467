package lightning.editor.window;

import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;

/** Goes on when a window was drawn. */
final class Drawn {
    /** The first is told before what is there is drawn, the second while it is, the third after it. */
    private static final int PULSES = 3;

    private Drawn() {}

    /** With all that is in it now: what comes next takes the window's thread and all processors for a while. */
    static void once(Runnable then) {
        new AnimationTimer() {
            private int pulses;

            @Override
            public void handle(long now) {
                if (++pulses == PULSES) {
                    stop();
                    then.run();
                }
            }
        }.start();
    }

    /**
     * With something that may not be there yet.
     *
     * @param there    whether it is
     * @param patience how long that is waited for, nanoseconds
     */
    static void with(BooleanSupplier there, long patience, Runnable then) {
        new AnimationTimer() {
            private long since;
            private boolean drawn;

            @Override
            public void handle(long now) {
                since = since == 0 ? now : since;
                if (drawn || now - since > patience) {
                    stop();
                    Platform.runLater(then);
                }
                // It is drawn after this.
                drawn = there.getAsBoolean();
            }
        }.start();
    }
}
