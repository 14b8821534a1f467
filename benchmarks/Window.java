package lightning.editor.window;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javafx.animation.AnimationTimer;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.scene.Scene;
import javafx.scene.layout.Pane;
import javafx.stage.Stage;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.LightEdits;
import lightning.document.loop.Frame;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.PictureView;
import lightning.render.engine.choice.Engines;
import lightning.scene.light.Light;

/** Measures an artist's waiting times in the real window, for {@code benchmarks/window}. Each printed line needs a process of its own. */
public final class Window {
    /** Start of the process, milliseconds since 1970. */
    private static final long START = Long.getLong("start");
    private static final OperatingSystemMXBean SYSTEM = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
    /** Duration of an edit session, milliseconds. */
    private static final long SESSION_MS = 60_000;
    /** Pause after each edit, milliseconds. */
    private static final long LOOK_MS = 500;
    /** Updates that take longer than this are listed, milliseconds. */
    private static final double SLOW_MS = 100;
    private static final long PAUSE_MS = 2;

    private Window() {}

    public static void main(String[] args) throws Exception {
        switch (args[0]) {
            case "empty" -> Application.launch(Empty.class);
            case "first" -> LightningApp.open(First.class, List.of(args[1]));
            case "warm" -> LightningApp.open(Warm.class, List.of(args[1]));
            case "minute" -> LightningApp.open(Minute.class, List.of(args[1]));
            case "slider" -> LightningApp.open(Slider.class, List.of(args[1], args[2], args[3]));
            default -> throw new IllegalArgumentException(args[0]);
        }
        System.exit(0);
    }

    static void print(String line, Object... values) {
        System.out.printf(Locale.ROOT, line + "%n", values);
    }

    /** Returns the elapsed time and the processor time of all threads since the start, milliseconds. */
    private static String sinceStart() {
        return (System.currentTimeMillis() - START) + " " + SYSTEM.getProcessCpuTime() / 1_000_000;
    }

    /** Runs an action after the condition first holds and the window is drawn again. */
    private static void runAfterDraw(Callable<Boolean> condition, Runnable then) {
        new AnimationTimer() {
            private int pulses;

            @Override
            public void handle(long now) {
                try {
                    pulses += pulses > 0 || condition.call() ? 1 : 0;
                } catch (Exception e) {
                    throw new IllegalStateException(e);
                }
                // Changes before the first pulse are drawn between it and the second.
                if (pulses == 2) {
                    stop();
                    then.run();
                }
            }
        }.start();
    }

    /** Empty window. */
    public static final class Empty extends Application {
        @Override
        public void start(Stage stage) {
            stage.setScene(new Scene(new Pane(), 1366, 768));
            stage.show();
            runAfterDraw(() -> true, () -> {
                print("empty %s", sinceStart());
                Platform.exit();
            });
        }
    }

    /** Start of the editor, until its window is complete. */
    public static final class First extends LightningApp {
        private String window;
        private String picture;

        @Override
        public void start(Stage stage) {
            super.start(stage);
            runAfterDraw(() -> true, () -> window = sinceStart());
            runAfterDraw(() -> stage.getScene().lookup("#traced-picture") instanceof PictureView view && !view.isEmpty(),
                    () -> picture = sinceStart());
        }

        @Override
        void editorOpened(Editor editor) {
            runAfterDraw(() -> editor.model().picture().frame() != null, () -> {
                print("window %s picture %s whole %s", window, picture, sinceStart());
                Platform.exit();
            });
        }
    }

    /** Editor that stays idle until the fastest engine is in use. */
    public static final class Warm extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> Window.run(() -> {
                await(() -> isIdle(editor.model()));
                String from = sinceStart();
                await(Engines::isFastestInUse);
                print("idle %s warm %s", from, sinceStart());
                return null;
            }));
        }
    }

    /** One minute of edits, immediately after a cold start. */
    public static final class Minute extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> Window.run(() -> runSession(editor.model())));
        }
    }

    /** Drags of a light's intensity, color and position, in a warm editor. */
    public static final class Slider extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            List<String> arguments = getParameters().getUnnamed();
            Thread.ofPlatform().daemon().start(() -> Window.run(() -> {
                Drag.measureAll(editor, Integer.parseInt(arguments.get(1)), Integer.parseInt(arguments.get(2)));
                return null;
            }));
        }
    }

    private static void run(Callable<?> work) {
        try {
            work.call();
        } catch (Throwable e) {
            e.printStackTrace();
        }
        Platform.exit();
    }

    static <T> T onWindow(Callable<T> task) throws Exception {
        var future = new FutureTask<>(task);
        Platform.runLater(future);
        return future.get();
    }

    static void await(Callable<Boolean> condition) throws Exception {
        while (!onWindow(condition)) {
            Thread.sleep(PAUSE_MS);
        }
    }

    static boolean isIdle(EditorModel model) {
        return model.picture().frame() != null && !model.editor().editorStateProperty().get().hasPendingEdits()
                && model.editor().editorStateProperty().get().sceneInProgress().isEmpty();
    }

    private static Light change(Light light, int i) {
        return switch (i % 4) {
            case 0 -> light.withIntensity(0.5 + 0.01 * i);
            case 1 -> light.withColor(new Rgb(1, 0.5 + 0.002 * i, 0.7));
            case 2 -> light.withPosition(light.position().plus(new Vec3(0.05, 0, 0.02)));
            default -> light.withDirection(light.direction().plus(new Vec3(0.01, 0, 0.01)));
        };
    }

    private static Void runSession(EditorModel model) throws Exception {
        await(() -> isIdle(model));
        onWindow(() -> {
            model.editor().liveProperty().set(true);
            return null;
        });
        List<Double> times = new ArrayList<>();
        List<String> slow = new ArrayList<>();
        long begin = System.nanoTime();
        for (int i = 0; System.nanoTime() - begin < SESSION_MS * 1_000_000; i++) {
            int step = i;
            String name = model.editor().scene().lights().get(i / 4 % model.editor().scene().lights().size()).name();
            Frame before = model.picture().frame();
            onWindow(() -> model.editor().edit(scene -> LightEdits.edit(scene, name, light -> change(light, step))));
            await(() -> isIdle(model));
            if (model.picture().frame() != before) {
                double ms = model.picture().frame().update().milliseconds();
                times.add(ms);
                if (ms > SLOW_MS) {
                    slow.add(String.format(Locale.ROOT, "%.0f ms after %.1f s", ms, (System.nanoTime() - begin) / 1e9));
                }
            }
            Thread.sleep(LOOK_MS);
        }
        double[] sorted = times.stream().mapToDouble(d -> d).sorted().toArray();
        print("edits %d median %.1f largest %.1f ms, first ten %s%s", sorted.length, sorted[sorted.length / 2], sorted[sorted.length - 1],
                times.subList(0, 10).stream().map(ms -> String.format(Locale.ROOT, "%.0f", ms)).toList(),
                slow.isEmpty() ? "" : ", long: " + slow);
        return null;
    }
}
