package lightning.editor.window;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.IntConsumer;
import java.util.function.UnaryOperator;
import javafx.application.Platform;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.TabPane;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.document.LightEdits;
import lightning.document.NodeEdits;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.render.image.DisplayCurve;
import lightning.scene.light.Light;
import lightning.scene.value.Placement;

/**
 * Measures how long each step of an artist's typical session blocks the window's thread. Prints the longest time that a task waited for
 * this thread, and the processor time that the thread used meanwhile. Other work on the machine does not lengthen the latter.
 * Arguments: a scene, another scene to open after it, and a glTF file without units of lights.
 */
public final class Pauses {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int DRAG_STEPS = 40;
    private static final long DRAG_MS = 30;
    private static final long LOOK_MS = 700;
    /** Idle time after the first picture, in which the editor preloads panels, milliseconds. */
    private static final long IDLE_MS = Long.getLong("look", 8000);

    private static List<String> arguments;

    private Pauses() {}

    public static void main(String[] args) {
        arguments = List.of(args);
        LightningApp.open(SessionApp.class, arguments.subList(0, 1));
        System.exit(0);
    }

    /** Editor with a scripted session. */
    public static final class SessionApp extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    new Session(editor).run();
                } catch (Throwable e) {
                    e.printStackTrace();
                }
                Platform.exit();
            });
        }
    }

    /** Sends tasks to the window's thread, one after the other, and records the longest wait. */
    private static final class ThreadProbe {
        private final AtomicLong passed = new AtomicLong();
        private final AtomicLong processor = new AtomicLong();
        private final long threadId;

        ThreadProbe(long threadId) {
            this.threadId = threadId;
            Thread.ofPlatform().daemon().start(this::run);
        }

        private void run() {
            while (true) {
                long cpu = THREADS.getThreadCpuTime(threadId);
                long begin = System.nanoTime();
                var answered = new CountDownLatch(1);
                Platform.runLater(answered::countDown);
                try {
                    answered.await();
                    passed.accumulateAndGet(System.nanoTime() - begin, Math::max);
                    processor.accumulateAndGet(THREADS.getThreadCpuTime(threadId) - cpu, Math::max);
                    Thread.sleep(1);
                } catch (InterruptedException e) {
                    return;
                }
            }
        }

        /** Returns the longest wait and processor time since the last call, milliseconds. */
        String takeLongest() {
            return String.format(Locale.ROOT, "%7.1f %7.1f", passed.getAndSet(0) / 1e6, processor.getAndSet(0) / 1e6);
        }
    }

    /** Steps of the session, in order. */
    private static final class Session {
        private final Editor editor;
        private final EditorModel model;
        private ThreadProbe probe;

        Session(Editor editor) {
            this.editor = editor;
            model = editor.model();
        }

        void run() throws Exception {
            probe = new ThreadProbe(onWindow(() -> Thread.currentThread().threadId()));
            awaitIdle("first seconds after the window opens");
            Thread.sleep(IDLE_MS);
            awaitIdle("idle, panels are preloaded");
            step("live updates on", () -> model.editor().liveProperty().set(true));
            String light = model.editor().scene().lights().getFirst().name();
            step("select a light", () -> model.editor().selection().selectLight(light));
            drag("drag its intensity", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            drag("drag its color", i -> edit(light, l -> l.withColor(new Rgb(1, 0.5 + 0.01 * i, 0.7))));
            drag("drag its position", i -> edit(light, l -> l.withPosition(l.position().plus(new Vec3(0.01, 0, 0.01)))));
            openMenus();
            for (Command panel : List.of(Command.MIXER, Command.CONTRIBUTIONS, Command.LOOKS, Command.SCOPES, Command.EFFECTS_PANEL,
                    Command.ACCURACY_PANEL, Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.KEYS, Command.PALETTE, Command.ABOUT)) {
                openAndClose(panel.plainTitle(), () -> model.commands().run(panel));
                openAndClose(panel.plainTitle() + ", again", () -> model.commands().run(panel));
            }
            editScene();
            arrangeWindow();
            for (Command panel : List.of(Command.MIXER, Command.CONTRIBUTIONS, Command.LOOKS, Command.SCOPES, Command.EFFECTS_PANEL,
                    Command.ACCURACY_PANEL, Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.KEYS)) {
                onWindow(() -> {
                    model.commands().run(panel);
                    return null;
                });
            }
            awaitIdle("open nine panels together");
            drag("drag its intensity, all panels open", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            command(Command.LIGHT_THEME, ", all panels open");
            command(Command.LIGHT_THEME, ", all panels open");
            step("close all panels", this::closeAll);
            switchScenes();
        }

        private void openMenus() throws Exception {
            for (Menu menu : onWindow(() -> List.copyOf(((MenuBar) mainStage().getScene().lookup(".menu-bar")).getMenus()))) {
                step("menu " + menu.getText(), menu::show);
                step("menu closed", menu::hide);
                step("menu " + menu.getText() + ", again", menu::show);
                step("menu closed", menu::hide);
            }
        }

        private void editScene() throws Exception {
            for (Command command : List.of(Command.ADD_LIGHT, Command.DUPLICATE_LIGHT, Command.SOLO, Command.SOLO, Command.NEW_LIGHT_GROUP,
                    Command.DELETE_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.ONLY_SELECTED,
                    Command.ONLY_SELECTED, Command.VERIFY, Command.UNDO, Command.REDO, Command.SAVE_SCENE)) {
                command(command, "");
            }
            step("show the material tab", () -> model.editor().materialShownProperty().set(true));
            String shape = model.editor().scene().placedShapes().getFirst().shape().name();
            step("select a shape", () -> model.editor().selection().selectNode(shape));
            drag("move it", _ -> model.editor().edit(scene -> NodeEdits.setPlacement(scene, shape,
                    p -> new Placement(p.position().plus(new Vec3(0, 0.001, 0)), p.rotation(), p.scale()))));
            String light = model.editor().scene().lights().getFirst().name();
            step("select a light again", () -> model.editor().selection().selectLight(light));
            step("show the list of shapes", () -> ((TabPane) mainStage().getScene().lookup("#lists")).getSelectionModel().select(1));
            step("show the list of lights", () -> ((TabPane) mainStage().getScene().lookup("#lists")).getSelectionModel().select(0));
            command(Command.NEW_SHOT, "");
            command(Command.TIMELINE, " hidden");
            command(Command.TIMELINE, " shown");
            command(Command.SET_KEY, "");
            command(Command.NEXT_FRAME, "");
            command(Command.FILM_STRIP, "");
            command(Command.FILM_STRIP, " hidden");
            openAndClose(Command.EXPORT_SHOT.plainTitle(), () -> model.commands().run(Command.EXPORT_SHOT));
            command(Command.DELETE_SHOT, "");
            command(Command.TIMELINE, " hidden");
        }

        private void arrangeWindow() throws Exception {
            for (DisplayCurve curve : List.of(DisplayCurve.FALSE, DisplayCurve.SRGB)) {
                step("curve " + curve, () -> model.picture().viewProperty().set(model.picture().viewProperty().get().withCurve(curve)));
            }
            command(Command.MARK_CLIPPING, "");
            command(Command.MARK_CLIPPING, "");
            for (CanvasLayout canvases : List.of(CanvasLayout.PICTURE_ALONE, CanvasLayout.PREVIEW_ALONE, CanvasLayout.SIDE_BY_SIDE)) {
                step(canvases.toString(), () -> model.layout().canvasLayoutProperty().set(canvases));
            }
            command(Command.HIDE_PANELS, " (Tab)");
            command(Command.HIDE_PANELS, " (Tab), again");
            command(Command.FULL_SCREEN, " (F11)");
            command(Command.FULL_SCREEN, " (F11), again");
            command(Command.LIGHT_THEME, "");
            command(Command.LIGHT_THEME, ", back");
            command(Command.LIGHT_THEME, ", second time");
            command(Command.LIGHT_THEME, ", back, second time");
            step(Command.LANGUAGE.plainTitle(), () -> model.languageProperty().set(UiLanguage.GERMAN));
        }

        private void switchScenes() throws Exception {
            command(Command.RELOAD, "");
            String light = model.editor().scene().lights().getFirst().name();
            step("edit a light", () -> edit(light, l -> l.withIntensity(0.77)));
            openAndClose("question about unsaved edits", () -> editor.files().load(Path.of(arguments.get(1))));
            command(Command.SAVE_SCENE, ", again");
            runLater("open another scene", () -> editor.files().load(Path.of(arguments.get(1))));
            openAndClose("import without units", () -> editor.files().load(Path.of(arguments.get(2))));
        }

        private void command(Command command, String suffix) throws Exception {
            step(command.plainTitle() + suffix, () -> model.commands().run(command));
        }

        private void edit(String light, UnaryOperator<Light> change) {
            model.editor().edit(scene -> LightEdits.edit(scene, light, change));
        }

        private static Stage mainStage() {
            return (Stage) Window.getWindows().stream().filter(w -> w instanceof Stage s && s.getOwner() == null).findFirst().orElseThrow();
        }

        private void closeAll() {
            List.copyOf(Window.getWindows()).stream().filter(w -> w != mainStage()).forEach(Window::hide);
        }

        /** Runs an action that opens a window, which can be modal, then closes the window. */
        private void openAndClose(String what, Runnable action) throws Exception {
            runLater(what, action);
            step(what + ": closed", this::closeAll);
        }

        private void runLater(String what, Runnable action) throws Exception {
            Platform.runLater(action);
            awaitIdle(what);
        }

        private void drag(String what, IntConsumer move) throws Exception {
            for (int i = 0; i < DRAG_STEPS; i++) {
                int at = i;
                onWindow(() -> {
                    move.accept(at);
                    return null;
                });
                Thread.sleep(DRAG_MS);
            }
            awaitIdle(what);
        }

        private void step(String what, Runnable action) throws Exception {
            onWindow(() -> {
                action.run();
                return null;
            });
            awaitIdle(what);
        }

        /** Waits until the editor is idle, then prints the longest wait. */
        private void awaitIdle(String after) throws Exception {
            do {
                Thread.sleep(LOOK_MS);
            } while (onWindow(() -> model.picture().frame() == null || model.fileActivity().file() != null
                    || model.editor().editorStateProperty().get().hasPendingEdits()
                    || model.editor().editorStateProperty().get().sceneInProgress().isPresent()));
            System.out.println(probe.takeLongest() + "  " + after);
        }
    }

    private static <T> T onWindow(Callable<T> task) throws Exception {
        var future = new FutureTask<>(task);
        Platform.runLater(future);
        return future.get();
    }
}
