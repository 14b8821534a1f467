package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.stage.Screen;
import javafx.stage.Stage;
import lightning.base.file.ShippedFile;
import lightning.editor.document.FileThread;
import lightning.editor.document.Recovery;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.model.Speech;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.Looks;
import lightning.editor.window.widget.PictureView;

/**
 * The editor's program: a window at once with a coarse picture in it, then the frame of all panes, then the pane of the traced picture, then
 * everything else. The scene is read and looked at while the window system starts.
 */
public class LightningApp extends Application {
    /** What is being read for the program that starts in this process; null where it was not begun by {@link #open}. */
    private static FutureTask<Opening> ahead;

    private static final long PATIENCE_MS = 600;
    /** How long a window that is there waits for a first look, before it shows that it waits; nanoseconds. */
    private static final long FIRST_PATIENCE_NS = 300_000_000;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final Recovery recovery = recovery();
    private Preferences preferences;
    /** What was read and nobody works at yet; else null. */
    private Opening opening;
    /** Null before it was drawn. */
    private EditorFrame frame;
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
        // The program's own preferences are read later, which write too.
        ahead = new FutureTask<>(() -> Opening.read(file, new Preferences(Folders.data(), _ -> {}), recovery));
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
        return arguments.isEmpty() ? Folders.firstScene() : ShippedFile.find(Path.of(arguments.getFirst()));
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
        Looks looks = preferences.choice("theme", Looks.DARK);
        var first = new FirstFrame(looks);
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        EditorStage.begin(stage, first, preferences, screen.getWidth(), screen.getHeight());
        thread.beside(() -> lookedAt(ahead == null ? Opening.read(file, preferences, recovery) : read(ahead)),
                read -> unlessClosed(stage, () -> {
                    glimpse(first.picture(), read);
                    opening = read;
                    begin(stage);
                }), why -> unlessClosed(stage, () -> {
                    looks.wear();
                    new Alert(Alert.AlertType.ERROR, Sentence.of(why), ButtonType.CLOSE).showAndWait();
                    Platform.exit();
                }));
        Drawn.with(() -> !first.picture().isEmpty(), FIRST_PATIENCE_NS, () -> unlessClosed(stage, () -> {
            looks.wear();
            Looks.dress(stage.getScene());
            Drawn.once(() -> unlessClosed(stage, () -> frame(stage, file, first.picture())));
        }));
    }

    /** Shows the panes, which say that they wait. */
    private void frame(Stage stage, Path file, PictureView picture) {
        var made = new EditorFrame(file, picture);
        stage.getScene().setRoot(made);
        Drawn.once(() -> unlessClosed(stage, () -> {
            frame = made;
            begin(stage);
        }));
    }

    private static Opening read(FutureTask<Opening> opening) throws Exception {
        // What it holds is for the first document alone.
        ahead = null;
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

    /** How long a scene that is read waits for a first look at it, milliseconds. */
    long patience() {
        return PATIENCE_MS;
    }

    private Opening lookedAt(Opening opening) throws InterruptedException {
        opening.glimpse().await(patience());
        return opening;
    }

    /** Shows what there is to be seen already. */
    private static void glimpse(PictureView picture, Opening read) {
        TracedRaster.Pixels seen = read.glimpse().raster().pixels();
        if (seen != null) {
            picture.setPixels(seen.width(), seen.height(), seen.pixels());
            picture.say(TracedPane.coarse());
        }
    }

    /** Nobody waits for a scene whose window was closed while it was read. */
    private static void unlessClosed(Stage stage, Runnable then) {
        if (stage.isShowing()) {
            then.run();
        }
    }

    /** Where the scene is read, and the window has its frame. */
    private void begin(Stage stage) {
        Opening read = opening;
        if (read != null && frame != null) {
            opening = null;
            sight = new FirstSight(frame, read.document(), read.glimpse(), preferences, recovery, thread);
            sight.whenSeen(() -> unlessClosed(stage, () -> show(stage, read)));
        }
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
