package lightning.editor.window.widget;

import java.util.Iterator;
import java.util.function.BooleanSupplier;
import javafx.animation.AnimationTimer;
import javafx.scene.Node;
import javafx.stage.Window;

/** Work of many small parts on the window's thread: in each pulse as many as leave the thread to all else that it has to do. */
public final class Slices {
    /** Less than a pulse, so that the picture goes on; a part that takes longer is alone in its pulse. */
    private static final long SLICE_NS = 10_000_000;

    private static int begun;

    private final BooleanSupplier part;
    private boolean going;
    private final AnimationTimer pulses = new AnimationTimer() {
        @Override
        public void handle(long now) {
            if (!slice()) {
                end();
            }
        }
    };

    /** @param part does the next part; returns whether there was one */
    public Slices(BooleanSupplier part) {
        this.part = part;
    }

    /** Does all parts once, as far as it comes each time that a pane is seen. */
    public static void whileSeen(Node pane, Iterator<Runnable> parts) {
        var slices = new Slices(() -> {
            if (parts.hasNext()) {
                parts.next().run();
            }
            return parts.hasNext();
        });
        WhileSeen.follow(pane, () -> {
            slices.begin();
            return slices::end;
        });
    }

    /** Does the first parts at once, and goes on in the pulses that follow until there is none left. */
    public void begin() {
        end();
        if (slice()) {
            going = true;
            begun++;
            pulses.start();
        }
    }

    /** Leaves what is not done. */
    public void end() {
        pulses.stop();
        if (going) {
            going = false;
            begun--;
        }
    }

    /** Whether any work waits for the next pulse. */
    public static boolean isAnyGoing() {
        return begun > 0;
    }

    /** A node takes on its looks at once, in this slice, where what is around it has its own: not while its window is about to open. */
    public static void style(Node node) {
        if (node.getScene() != null && Window.getWindows().contains(node.getScene().getWindow())) {
            node.applyCss();
        }
    }

    private boolean slice() {
        long begin = System.nanoTime();
        long now = begin;
        long last;
        do {
            last = now;
            if (!part.getAsBoolean()) {
                return false;
            }
            now = System.nanoTime();
            // What comes next may take as long as the last.
        } while (now + (now - last) < begin + SLICE_NS);
        return true;
    }
}
