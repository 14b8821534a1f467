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
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.document.NodeEdits;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.render.image.DisplayCurve;
import lightning.scene.Light;
import lightning.scene.Placement;

/**
 * How long the window's thread is away in an hour's work told in two minutes: for each thing that an artist does the longest time that a
 * task waited for that thread, and the processor time that the thread took meanwhile, which other work on the machine does not
 * lengthen. Arguments: a scene, another one that is opened after it, and a glTF file that does not tell the units of its lights.
 */
public final class Pauses {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int DRAG = 40;
    private static final long DRAG_MS = 30;
    private static final long LOOK_MS = 700;
    /** How long an artist looks at the first picture: some seconds, or none. */
    private static final long NOBODY_MS = Long.getLong("look", 8000);

    /** What is being done. */
    static volatile String step = "";

    private static List<String> arguments;

    private Pauses() {}

    public static void main(String[] args) {
        arguments = List.of(args);
        LightningApp.open(Story.class, arguments.subList(0, 1));
        System.exit(0);
    }

    /** The editor, and who works at it. */
    public static final class Story extends LightningApp {
        @Override
        void editorOpened(Editor editor) {
            Thread.ofPlatform().daemon().start(() -> {
                try {
                    new Hour(editor).work();
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
        private final Editor editor;
        private final EditorModel model;
        private Pulse pulse;

        Hour(Editor editor) {
            this.editor = editor;
            model = editor.model();
        }

        void work() throws Exception {
            pulse = new Pulse(onWindow(() -> Thread.currentThread().threadId()));
            rest("the first seconds after the window is there");
            Thread.sleep(NOBODY_MS);
            rest("nobody works, and panels are made ahead");
            step("live", () -> model.editor().liveProperty().set(true));
            String light = model.editor().scene().lights().getFirst().name();
            step("a light selected", () -> model.editor().selection().selectLight(light));
            drag("its intensity dragged", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            drag("its color dragged", i -> edit(light, l -> l.withColor(new Rgb(1, 0.5 + 0.01 * i, 0.7))));
            drag("its place dragged", i -> edit(light, l -> l.withPosition(l.position().plus(new Vec3(0.01, 0, 0.01)))));
            menus();
            for (Command panel : List.of(Command.MIXER, Command.CONTRIBUTIONS, Command.CUES, Command.SCOPES, Command.EFFECTS_PANEL,
                    Command.ACCURACY_PANEL, Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.KEYS, Command.PALETTE, Command.ABOUT,
                    Command.MAKE_ANIMATION)) {
                beside(panel.plainTitle(), () -> model.commands().run(panel));
                beside(panel.plainTitle() + ", again", () -> model.commands().run(panel));
            }
            model();
            arrange();
            for (Command panel : List.of(Command.MIXER, Command.CONTRIBUTIONS, Command.CUES, Command.SCOPES, Command.EFFECTS_PANEL,
                    Command.ACCURACY_PANEL, Command.UPDATES_PANEL, Command.HISTORY_PANEL, Command.KEYS)) {
                onWindow(() -> {
                    model.commands().run(panel);
                    return null;
                });
            }
            rest("nine panels opened at once");
            drag("its intensity dragged, all panels open", i -> edit(light, l -> l.withIntensity(0.5 + 0.01 * i)));
            command(Command.LIGHT_THEME, ", all panels open");
            command(Command.LIGHT_THEME, ", all panels open");
            step("all panels closed", this::closeAll);
            scenes();
        }

        private void menus() throws Exception {
            for (Menu menu : onWindow(() -> List.copyOf(((MenuBar) main().getScene().lookup(".menu-bar")).getMenus()))) {
                step("menu " + menu.getText(), menu::show);
                step("menu closed", menu::hide);
                step("menu " + menu.getText() + ", again", menu::show);
                step("menu closed", menu::hide);
            }
        }

        private void model() throws Exception {
            for (Command command : List.of(Command.ADD_LIGHT, Command.DUPLICATE_LIGHT, Command.SOLO, Command.SOLO, Command.NEW_BANK,
                    Command.DELETE_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.LOOK_THROUGH_LIGHT, Command.ONLY_SELECTED,
                    Command.ONLY_SELECTED, Command.VERIFY, Command.UNDO, Command.REDO, Command.SAVE_SCENE)) {
                command(command, "");
            }
            step("the material's tab", () -> model.editor().materialShownProperty().set(true));
            String shape = model.editor().scene().placedShapes().getFirst().shape().name();
            step("a shape selected", () -> model.editor().selection().selectNode(shape));
            drag("it is moved", _ -> model.editor().edit(scene -> NodeEdits.setPlacement(scene, shape,
                    p -> new Placement(p.position().plus(new Vec3(0, 0.001, 0)), p.rotation(), p.scale()))));
            String light = model.editor().scene().lights().getFirst().name();
            step("a light selected again", () -> model.editor().selection().selectLight(light));
            step("the list of shapes", () -> ((TabPane) main().getScene().lookup("#lists")).getSelectionModel().select(1));
            step("the list of lights", () -> ((TabPane) main().getScene().lookup("#lists")).getSelectionModel().select(0));
            command(Command.NEW_SHOT, "");
            command(Command.TIMELINE, " hidden");
            command(Command.TIMELINE, " shown");
            command(Command.SET_KEY, "");
            command(Command.NEXT_FRAME, "");
            command(Command.FILM_STRIP, "");
            command(Command.FILM_STRIP, " hidden");
            beside(Command.EXPORT_SHOT.plainTitle(), () -> model.commands().run(Command.EXPORT_SHOT));
            command(Command.DELETE_SHOT, "");
            command(Command.TIMELINE, " hidden");
        }

        private void arrange() throws Exception {
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

        private void scenes() throws Exception {
            command(Command.RELOAD, "");
            String light = model.editor().scene().lights().getFirst().name();
            step("an edit", () -> edit(light, l -> l.withIntensity(0.77)));
            beside("question about unsaved edits", () -> editor.files().load(Path.of(arguments.get(1))));
            command(Command.SAVE_SCENE, ", again");
            later("another scene opened", () -> editor.files().load(Path.of(arguments.get(1))));
            beside("import asks for units", () -> editor.files().load(Path.of(arguments.get(2))));
        }

        private void command(Command command, String how) throws Exception {
            step(command.plainTitle() + how, () -> model.commands().run(command));
        }

        private void edit(String light, UnaryOperator<Light> change) {
            model.editor().edit(scene -> LightEdits.edit(scene, light, change));
        }

        private static Stage main() {
            return (Stage) Window.getWindows().stream().filter(w -> w instanceof Stage s && s.getOwner() == null).findFirst().orElseThrow();
        }

        private void closeAll() {
            List.copyOf(Window.getWindows()).stream().filter(w -> w != main()).forEach(Window::hide);
        }

        /** What opens a window, which may wait for an answer, and is closed then. */
        private void beside(String what, Runnable action) throws Exception {
            later(what, action);
            step(what + ": closed", this::closeAll);
        }

        private void later(String what, Runnable action) throws Exception {
            step = what;
            Platform.runLater(action);
            rest(what);
        }

        private void drag(String what, IntConsumer move) throws Exception {
            step = what;
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
            step = what;
            onWindow(() -> {
                action.run();
                return null;
            });
            rest(what);
        }

        private void rest(String after) throws Exception {
            do {
                Thread.sleep(LOOK_MS);
            } while (onWindow(() -> model.picture().frame() == null || model.fileActivity().file() != null
                    || model.editor().editorStateProperty().get().hasPendingEdits()
                    || model.editor().editorStateProperty().get().sceneInProgress().isPresent()));
            System.out.println(pulse.longest() + "  " + after);
        }
    }

    private static <T> T onWindow(Callable<T> task) throws Exception {
        var future = new FutureTask<>(task);
        Platform.runLater(future);
        return future.get();
    }
}
