package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;
import static lightning.editor.window.Window.print;

import com.sun.javafx.perf.PerformanceTracker;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import java.util.stream.LongStream;
import javafx.application.Platform;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import lightning.document.EditOutcome;
import lightning.document.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.render.engine.choice.Engines;

/**
 * Measures the latency from a mouse drag event to the drawn picture, and each step in between. Drags the widgets of the first light's
 * properties.
 */
final class Drag {
    /** Drag steps that are not measured. */
    private static final int WARM_UPS = 100;
    /** Measured drag steps. */
    private static final int SAMPLES = 60;
    /** Pause between steps, milliseconds. */
    private static final long STEP_MS = 90;
    /** Distance that the mouse moves forth and back, pixels. */
    private static final int DRAG_LENGTH = 40;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final List<String> PARTS = List.of("update", "handler", "handler to window", "to layout", "to screen", "total",
            "total / update");

    private final Scene scene;
    private final String property;
    /** Times in nanoseconds when the window received the picture, laid it out and drew it; 0 until then. */
    private long received;
    private long laidOut;
    private volatile long drawn;
    private Frame frame;

    private Drag(EditorModel model, Scene scene, String property) {
        this.scene = scene;
        this.property = property;
        frame = model.picture().frame();
        model.picture().renderStateProperty().subscribe(state -> {
            if (state.frame() != frame && received == 0) {
                frame = state.frame();
                received = System.nanoTime();
            }
        });
        scene.addPostLayoutPulseListener(() -> laidOut = received != 0 && laidOut == 0 ? System.nanoTime() : laidOut);
        PerformanceTracker.getSceneTracker(scene).setOnRenderedFrameTask(() -> {
            long now = System.nanoTime();
            Platform.runLater(() -> drawn = laidOut != 0 && now > laidOut && drawn == 0 ? now : drawn);
        });
    }

    /** Measures drags of the first light's intensity, color and position in a picture of this size. */
    static void measureAll(Editor editor, int width, int height) throws Exception {
        EditorModel model = editor.model();
        Engines.use(Engines.FASTEST);
        onWindow(() -> {
            model.editor().liveProperty().set(true);
            return model.editor().edit(scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withSize(width, height))));
        });
        await(() -> Window.isIdle(model));
        Scene scene = onWindow(() -> javafx.stage.Window.getWindows().getFirst().getScene());
        onWindow(() -> {
            model.editor().selection().selectLight(model.editor().scene().lights().getFirst().name());
            return null;
        });
        await(() -> Window.isIdle(model));
        for (String property : List.of("intensity", "color", "position")) {
            Drag drag = onWindow(() -> new Drag(model, scene, property));
            drag.measure(onWindow(drag::pressMouse));
        }
    }

    /** Presses the mouse and returns a function that drags it to the position of a step. */
    private IntConsumer pressMouse() {
        Node handle = scene.lookup(switch (property) {
            case "intensity" -> "#intensity .arrow-pad";
            case "color" -> "#color .color-slider .thumb";
            case "position" -> "#position .axis-x";
            default -> throw new IllegalArgumentException(property);
        });
        Point2D at = handle.localToScene(handle.getLayoutBounds().getCenterX(), handle.getLayoutBounds().getCenterY());
        fireMouse(handle, MouseEvent.MOUSE_PRESSED, at);
        return step -> {
            int offset = DRAG_LENGTH - Math.abs(step % (2 * DRAG_LENGTH) - DRAG_LENGTH);
            fireMouse(handle, MouseEvent.MOUSE_DRAGGED,
                    property.equals("intensity") ? at.subtract(0, 3 + offset) : at.subtract(3 + offset, 0));
        };
    }

    /**
     * Fires a mouse event, with Shift for a position, so that it moves slowly.
     *
     * @param at position in the window's scene
     */
    private void fireMouse(Node handle, EventType<MouseEvent> type, Point2D at) {
        Event.fireEvent(handle, new MouseEvent(type, at.getX(), at.getY(), at.getX(), at.getY(), MouseButton.PRIMARY, 1,
                property.equals("position"), false, false, false, true, false, false, false, false, true, null));
    }

    /** Returns the processor time of the window's thread, of the drawing thread and of all Java threads, nanoseconds. */
    private static long[] processorTime() {
        long[] all = THREADS.getAllThreadIds();
        return new long[] {cpuTime(all, "JavaFX Application Thread"), cpuTime(all, "QuantumRenderer"), cpuTime(all, "")};
    }

    private static long cpuTime(long[] threads, String name) {
        return LongStream.of(threads)
                .filter(id -> THREADS.getThreadInfo(id) != null && THREADS.getThreadInfo(id).getThreadName().startsWith(name))
                .map(THREADS::getThreadCpuTime).sum();
    }

    private void measure(IntConsumer dragTo) throws Exception {
        double[][] ms = new double[PARTS.size()][SAMPLES];
        long[] begin = null;
        for (int i = -WARM_UPS; i < SAMPLES; i++) {
            int step = i + WARM_UPS + 1;
            begin = i == 0 ? processorTime() : begin;
            Thread.sleep(STEP_MS + (i * 7 & 31));
            long start = System.nanoTime();
            long edited = onWindow(() -> {
                received = laidOut = drawn = 0;
                dragTo.accept(step);
                return System.nanoTime();
            });
            await(() -> drawn != 0);
            double update = frame.update().milliseconds();
            double[] sample = {update, edited - start, received - edited, laidOut - received, drawn - laidOut, drawn - start, 0};
            for (int k = 1; k < 6; k++) {
                sample[k] /= 1e6;
            }
            sample[6] = sample[5] / update;
            for (int k = 0; k < sample.length; k++) {
                ms[k][Math.max(i, 0)] = sample[k];
            }
        }
        long[] end = processorTime();
        for (int k = 0; k < ms.length; k++) {
            Arrays.sort(ms[k]);
            print("%-10s %-24s %8.2f   %.2f to %.2f", property, PARTS.get(k), ms[k][SAMPLES / 2], ms[k][SAMPLES / 4],
                    ms[k][3 * SAMPLES / 4]);
        }
        print("%-10s processor time per step: window's thread %.1f, drawing thread %.1f, all Java threads %.1f ms",
                property, (end[0] - begin[0]) / 1e6 / SAMPLES, (end[1] - begin[1]) / 1e6 / SAMPLES, (end[2] - begin[2]) / 1e6 / SAMPLES);
    }
}
