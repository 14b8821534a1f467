package lightning.app;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javafx.animation.AnimationTimer;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.stage.Screen;
import javafx.stage.Stage;
import lightning.app.command.FilePrompt;
import lightning.app.model.Preferences;
import lightning.app.model.Sentence;
import lightning.app.model.Speech;
import lightning.app.widget.Looks;
import lightning.edit.FileThread;
import lightning.edit.Recovery;

/**
 * The editor's program: a window at once, the traced picture in it as soon as there is one, then everything else. The scene is
 * read while the window system starts.
 */
public class LightningApp extends Application {
    /** What is being read for the program that starts in this process; null where it was not begun by {@link #open}. */
    private static FutureTask<Opening> ahead;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final Recovery recovery = recovery();
    private Preferences preferences;
    private FirstSight sight;
    private Editor editor;
    private Ahead beforehand;

    /**
     * Opens the editor and returns when its window is closed. At most once in a process.
     *
     * @param arguments the file to open, a scene or one of which a scene can be made, or nothing
     * @return why no window can be opened, as {@link Display#obstacle} tells; empty if one was
     */
    public static Optional<String> open(List<String> arguments) {
        return open(LightningApp.class, arguments);
    }

    static Optional<String> open(Class<? extends LightningApp> program, List<String> arguments) {
        Path file = file(arguments);
        Recovery recovery = recovery();
        ahead = new FutureTask<>(() -> Opening.read(file, recovery));
        Thread.ofPlatform().daemon().name("lightning-opening").start(ahead);
        Optional<String> obstacle = Display.obstacle();
        if (obstacle.isEmpty()) {
            launch(program, arguments.toArray(String[]::new));
        }
        return obstacle;
    }

    /** Whether the editor opens a file, by its name. */
    public static boolean opens(String file) {
        return Opening.isNamedSo(file);
    }

    /** The file to open. */
    Path file() {
        return file(getParameters() == null ? List.of() : getParameters().getUnnamed());
    }

    private static Path file(List<String> arguments) {
        return arguments.isEmpty() ? Folders.firstScene() : Path.of(arguments.getFirst());
    }

    private static Recovery recovery() {
        return new Recovery(Folders.data().resolve("recovery"));
    }

    /** Before there is a window that could wait for a disk. */
    @Override
    public void init() {
        preferences = new Preferences(Folders.data(), thread);
        Speech.begin(preferences);
    }

    @Override
    public void start(Stage stage) {
        Path file = file();
        preferences.choice("theme", Looks.DARK).wear();
        var frame = new EditorFrame(file);
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        EditorStage.show(stage, frame, preferences, screen.getWidth(), screen.getHeight());
        thread.beside(() -> ahead == null ? Opening.read(file, recovery) : read(ahead),
                opening -> onceDrawn(() -> unlessClosed(stage, () -> begin(stage, frame, opening))), why -> unlessClosed(stage, () -> {
                    new Alert(Alert.AlertType.ERROR, Sentence.of(why), ButtonType.CLOSE).showAndWait();
                    Platform.exit();
                }));
    }

    private static Opening read(FutureTask<Opening> opening) throws Exception {
        try {
            return opening.get();
        } catch (ExecutionException e) {
            switch (e.getCause()) {
                case Exception why -> throw why;
                case Error why -> throw why;
                case Throwable why -> throw new IllegalStateException(why);
            }
        }
    }

    /** Nobody waits for a scene whose window was closed while it was read. */
    private static void unlessClosed(Stage stage, Runnable then) {
        if (stage.isShowing()) {
            then.run();
        }
    }

    /** Once the window stands on the screen: what comes next takes this thread and all processors for a while. */
    private static void onceDrawn(Runnable then) {
        new AnimationTimer() {
            private int pulses;

            @Override
            public void handle(long now) {
                // The first is told before the window is drawn for the first time, the second while it is, the third after it.
                if (++pulses == 3) {
                    stop();
                    then.run();
                }
            }
        }.start();
    }

    private void begin(Stage stage, EditorFrame frame, Opening opening) {
        sight = new FirstSight(frame, opening.document(), preferences, recovery, thread);
        sight.whenSeen(() -> unlessClosed(stage, () -> show(stage, opening)));
    }

    private void show(Stage stage, Opening opening) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        editor = new Editor(stage, sight, preferences, thread, FilePrompt.of(stage), screen.getWidth(), screen.getHeight());
        if (opening.failed() != null) {
            editor.failed(opening.failed(), opening.why());
        }
        beforehand = new Ahead(stage.getScene(), editor::rests, editor.window().ahead().iterator());
        opened(editor);
        editor.offer(opening.left());
        if (opening.next() != null) {
            editor.files().load(opening.next());
        }
    }

    /** An editor has its window. */
    void opened(Editor opened) {}

    @Override
    public void stop() {
        if (editor != null) {
            beforehand.close();
            editor.close();
        } else if (sight != null) {
            sight.close();
        }
    }
}
