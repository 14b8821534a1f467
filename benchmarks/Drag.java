package lightning.editor.window;

import static lightning.editor.window.Window.await;
import static lightning.editor.window.Window.onWindow;
import static lightning.editor.window.Window.say;

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
import lightning.editor.document.EditOutcome;
import lightning.editor.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.render.engine.choice.Engines;

/** From the event of a drag to the drawn picture, and what lies between: widgets of the first light's properties, dragged by the mouse. */
final class Drag {
    /** Steps before those that count, these, and the time between them, milliseconds. */
    private static final int WARM_UPS = 100;
    private static final int SAMPLES = 60;
    private static final long STEP_MS = 90;
    /** The mouse goes so far one way and back, pixels. */
    private static final int WAY = 40;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final List<String> PARTS = List.of("update", "handler", "after it to the window", "to layout", "to screen", "all",
            "all / update");

    private final Scene scene;
    private final String what;
    /** When the window heard of the picture, its next layout, and when that was drawn; 0 for not yet. */
    private long heard;
    private long laidOut;
    private volatile long drawn;
    private Frame frame;

    private Drag(EditorModel model, Scene scene, String what) {
        this.scene = scene;
        this.what = what;
        frame = model.picture().frame();
        model.picture().renderStateProperty().subscribe(state -> {
            if (state.frame() != frame && heard == 0) {
                frame = state.frame();
                heard = System.nanoTime();
            }
        });
        scene.addPostLayoutPulseListener(() -> laidOut = heard != 0 && laidOut == 0 ? System.nanoTime() : laidOut);
        PerformanceTracker.getSceneTracker(scene).setOnRenderedFrameTask(() -> {
            long now = System.nanoTime();
            Platform.runLater(() -> drawn = laidOut != 0 && now > laidOut && drawn == 0 ? now : drawn);
        });
    }

    /** Intensity, color and place of the first light, in a picture of a size. */
    static void all(Editor editor, int width, int height) throws Exception {
        EditorModel model = editor.model();
        Engines.use(Engines.FASTEST);
        onWindow(() -> {
            model.editor().liveProperty().set(true);
            return model.editor().edit(scene -> EditOutcome.of(() -> scene.withPicture(scene.picture().withSize(width, height))));
        });
        await(() -> Window.rests(model));
        Scene scene = onWindow(() -> javafx.stage.Window.getWindows().getFirst().getScene());
        onWindow(() -> {
            model.editor().selection().selectLight(model.editor().scene().lights().getFirst().name());
            return null;
        });
        await(() -> Window.rests(model));
        for (String what : List.of("intensity", "color", "position")) {
            Drag drag = onWindow(() -> new Drag(model, scene, what));
            drag.measure(onWindow(drag::hand));
        }
    }

    /** Presses the mouse; what is returned drags it to a step's place. */
    private IntConsumer hand() {
        Node handle = scene.lookup(switch (what) {
            case "intensity" -> "#intensity .arrow-pad";
            case "color" -> "#color .color-slider .thumb";
            case "position" -> "#position .axis-x";
            default -> throw new IllegalArgumentException(what);
        });
        Point2D at = handle.localToScene(handle.getLayoutBounds().getCenterX(), handle.getLayoutBounds().getCenterY());
        mouse(handle, MouseEvent.MOUSE_PRESSED, at);
        return step -> {
            int way = WAY - Math.abs(step % (2 * WAY) - WAY);
            mouse(handle, MouseEvent.MOUSE_DRAGGED, what.equals("intensity") ? at.subtract(0, 3 + way) : at.subtract(3 + way, 0));
        };
    }

    /** @param at in the window's scene; Shift is held where a place is dragged, so that it stays near */
    private void mouse(Node handle, EventType<MouseEvent> type, Point2D at) {
        Event.fireEvent(handle, new MouseEvent(type, at.getX(), at.getY(), at.getX(), at.getY(), MouseButton.PRIMARY, 1,
                what.equals("position"), false, false, false, true, false, false, false, false, true, null));
    }

    private static long[] processorTime() {
        long[] all = THREADS.getAllThreadIds();
        return new long[] {of(all, "JavaFX Application Thread"), of(all, "QuantumRenderer"), of(all, "")};
    }

    private static long of(long[] threads, String name) {
        return LongStream.of(threads)
                .filter(id -> THREADS.getThreadInfo(id) != null && THREADS.getThreadInfo(id).getThreadName().startsWith(name))
                .map(THREADS::getThreadCpuTime).sum();
    }

    private void measure(IntConsumer hand) throws Exception {
        double[][] ms = new double[PARTS.size()][SAMPLES];
        long[] began = null;
        for (int i = -WARM_UPS; i < SAMPLES; i++) {
            int step = i + WARM_UPS + 1;
            began = i == 0 ? processorTime() : began;
            Thread.sleep(STEP_MS + (i * 7 & 31));
            long start = System.nanoTime();
            long edited = onWindow(() -> {
                heard = laidOut = drawn = 0;
                hand.accept(step);
                return System.nanoTime();
            });
            await(() -> drawn != 0);
            double update = frame.update().milliseconds();
            double[] sample = {update, edited - start, heard - edited, laidOut - heard, drawn - laidOut, drawn - start, 0};
            for (int k = 1; k < 6; k++) {
                sample[k] /= 1e6;
            }
            sample[6] = sample[5] / update;
            for (int k = 0; k < sample.length; k++) {
                ms[k][Math.max(i, 0)] = sample[k];
            }
        }
        long[] ended = processorTime();
        for (int k = 0; k < ms.length; k++) {
            Arrays.sort(ms[k]);
            say("%-10s %-24s %8.2f   %.2f to %.2f", what, PARTS.get(k), ms[k][SAMPLES / 2], ms[k][SAMPLES / 4], ms[k][3 * SAMPLES / 4]);
        }
        say("%-10s processor time a step: the window's thread %.1f, the drawing one %.1f, all of Java's %.1f ms", what,
                (ended[0] - began[0]) / 1e6 / SAMPLES, (ended[1] - began[1]) / 1e6 / SAMPLES, (ended[2] - began[2]) / 1e6 / SAMPLES);
    }
}
