package lightning.app;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import lightning.app.model.EditorModel;
import lightning.edit.Command;
import lightning.edit.LightEdits;
import lightning.edit.NodeEdits;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Light;
import lightning.scene.Placement;

/**
 * How long the window's thread is away in an hour's work told in a minute: for each step the longest time that a task waited for it, and the
 * processor time that the thread took meanwhile, which other work on the machine does not lengthen.
 */
public final class Pauses {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int DRAG = 40;
    private static final long DRAG_MS = 30;
    private static final long LOOK_MS = 1200;

    private Pauses() {}

    public static void main(String[] args) {
        LightningApp.open(Story.class, List.of(args[0]));
        System.exit(0);
    }

    /** The editor, and who works at it. */
    public static final class Story extends LightningApp {
        @Override
        void opened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    new Hour(editor.model()).work();
                } catch (Throwable e) {
                    e.printStackTrace();
                }
                Platform.exit();
            });
        }
    }

    /** Asks the window's thread again and again whether it is there. */
    private static final class Pulse {
        private final AtomicLong passed = new AtomicLong();
        private final AtomicLong processor = new AtomicLong();
        private final long window;

        Pulse(long window) {
            this.window = window;
            Thread.ofPlatform().daemon().start(this::beat);
        }

        private void beat() {
            while (true) {
                long cpu = THREADS.getThreadCpuTime(window);
                long begin = System.nanoTime();
                var answered = new CountDownLatch(1);
                Platform.runLater(answered::countDown);
                try {
                    answered.await();
                    passed.accumulateAndGet(System.nanoTime() - begin, Math::max);
                    processor.accumulateAndGet(THREADS.getThreadCpuTime(window) - cpu, Math::max);
                    Thread.sleep(1);
                } catch (InterruptedException e) {
                    return;
                }
            }
        }

        /** The longest since this was asked last, milliseconds. */
        String longest() {
            return String.format(Locale.ROOT, "%7.1f %7.1f", passed.getAndSet(0) / 1e6, processor.getAndSet(0) / 1e6);
        }
    }

    /** What is done, a step after the other. */
    private static final class Hour {
        private final EditorModel model;
        private Pulse pulse;

        Hour(EditorModel model) {
            this.model = model;
        }

        void work() throws Exception {
            pulse = new Pulse(onWindow(() -> Thread.currentThread().threadId()));
            rest("the first seconds after the window is there");
            step("live", () -> model.liveProperty().set(true));
            String light = model.lights().getFirst().name();
            step("a light selected", () -> model.selectLight(light));
            drag("its intensity dragged", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            drag("its colour dragged", i -> edit(light, l -> l.withColor(new Rgb(1, 0.5 + 0.01 * i, 0.7))));
            drag("its place dragged", i -> edit(light, l -> l.withPosition(l.position().plus(new Vec3(0.01, 0, 0.01)))));
            for (Command panel : List.of(Command.MIXER, Command.CONTRIBUTIONS, Command.CUES, Command.SCOPES, Command.EFFECTS_PANEL,
                    Command.ACCURACY_PANEL, Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.PALETTE, Command.KEYS, Command.ABOUT)) {
                step(panel.plainTitle(), () -> model.run(panel));
            }
            drag("its intensity dragged, all panels open", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            for (Command command : List.of(Command.ADD_LIGHT, Command.DUPLICATE_LIGHT, Command.SOLO, Command.SOLO, Command.NEW_BANK,
                    Command.DELETE_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.ONLY_SELECTED,
                    Command.ONLY_SELECTED, Command.VERIFY, Command.HIDE_PANELS, Command.HIDE_PANELS, Command.LIGHT_THEME,
                    Command.LIGHT_THEME, Command.UNDO, Command.REDO, Command.SAVE_SCENE)) {
                step(command.plainTitle(), () -> model.run(command));
            }
            String shape = model.scene().placedShapes().getFirst().shape().name();
            step("a shape selected", () -> model.selectNode(shape));
            drag("it is moved", _ -> model.edit(scene -> NodeEdits.placement(scene, shape,
                    p -> new Placement(p.at().plus(new Vec3(0, 0.001, 0)), p.rotate(), p.scale()))));
            step(Command.RELOAD.plainTitle(), () -> model.run(Command.RELOAD));
        }

        private void edit(String light, UnaryOperator<Light> change) {
            model.edit(scene -> LightEdits.with(scene, light, change));
        }

        private void drag(String what, IntConsumer move) throws Exception {
            for (int i = 0; i < DRAG; i++) {
                int at = i;
                onWindow(() -> {
                    move.accept(at);
                    return null;
                });
                Thread.sleep(DRAG_MS);
            }
            rest(what);
        }

        private void step(String what, Runnable action) throws Exception {
            onWindow(() -> {
                action.run();
                return null;
            });
            rest(what);
        }

        private void rest(String after) throws Exception {
            do {
                Thread.sleep(LOOK_MS);
            } while (onWindow(() -> model.frame() == null || model.situationProperty().get().isPending()
                    || model.situationProperty().get().inWork().isPresent()));
            System.out.println(pulse.longest() + "  " + after);
        }
    }

    private static <T> T onWindow(Callable<T> task) throws Exception {
        var future = new FutureTask<>(task);
        Platform.runLater(future);
        return future.get();
    }
}
