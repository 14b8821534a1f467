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
import lightning.editor.document.RecoveryFolder;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.PictureView;

/**
 * The editor's program: a window at once with a coarse picture in it, then the frame of all panes, then the pane of the traced picture, then
 * everything else. The scene is read and looked at while the window system starts.
 */
public class LightningApp extends Application {
    /** What is being read for the program that starts in this process; null where it was not begun by {@link #open}. */
    private static FutureTask<StartupFiles> startupRead;

    private static final long PREVIEW_TIMEOUT_MS = 600;
    /** How long a window that is there waits for a first look, before it shows that it waits; nanoseconds. */
    private static final long FIRST_PICTURE_TIMEOUT_NS = 300_000_000;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final RecoveryFolder recovery = recovery();
    private Preferences preferences;
    /** What was read and nobody works at yet; else null. */
    private StartupFiles startupFiles;
    /** Null before it was drawn. */
    private EditorLayout layout;
    private StartupSession startupSession;
    private Editor editor;
    private IdlePreloader preloader;

    /**
     * Opens the editor and returns when its window is closed. At most once in a process.
     *
     * @param arguments the file to open, a scene or one of which a scene can be made, or nothing
     * @return why no window can be opened, as {@link WindowToolkit#start} tells; empty if one was
     */
    public static Optional<String> open(List<String> arguments) {
        return open(LightningApp.class, arguments);
    }

    static Optional<String> open(Class<? extends LightningApp> program, List<String> arguments) {
        Path file = file(arguments);
        RecoveryFolder recovery = recovery();
        // The program's own preferences are read later, which write too.
        startupRead = new FutureTask<>(() -> StartupFiles.read(file, new Preferences(EditorPaths.dataFolder(), _ -> {}), recovery));
        Thread.ofPlatform().daemon().name("lightning-opening").start(startupRead);
        Optional<String> problem = WindowToolkit.start();
        if (problem.isEmpty()) {
            launch(program, arguments.toArray(String[]::new));
        }
        return problem;
    }

    /** Whether the editor opens a file, by its name. */
    public static boolean canOpen(String file) {
        return StartupFiles.canOpen(file);
    }

    /** The file to open. */
    Path file() {
        return file(getParameters() == null ? List.of() : getParameters().getUnnamed());
    }

    private static Path file(List<String> arguments) {
        return arguments.isEmpty() ? EditorPaths.defaultScene() : ShippedFile.resolve(Path.of(arguments.getFirst()));
    }

    private static RecoveryFolder recovery() {
        return new RecoveryFolder(EditorPaths.dataFolder().resolve("recovery"));
    }

    /** Before there is a window that could wait for a disk. */
    @Override
    public void init() {
        preferences = new Preferences(EditorPaths.dataFolder(), thread);
        UiLanguage.activate(preferences);
    }

    @Override
    public void start(Stage stage) {
        Path file = file();
        ColorTheme looks = preferences.enumValue("theme", ColorTheme.DARK);
        var startupView = new StartupView(looks);
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        EditorStage.showUnstyled(stage, startupView, preferences, screen.getWidth(), screen.getHeight());
        thread.runConcurrently(() -> awaitPreview(startupRead == null ? StartupFiles.read(file, preferences, recovery) : read(startupRead)),
                result -> runIfOpen(stage, () -> {
                    showFirstPixels(startupView.picture(), result);
                    startupFiles = result;
                    showIfReady(stage);
                }), failure -> runIfOpen(stage, () -> {
                    looks.apply();
                    new Alert(Alert.AlertType.ERROR, ErrorMessage.of(failure), ButtonType.CLOSE).showAndWait();
                    Platform.exit();
                }));
        PaintCallbacks.afterPaintOf(() -> !startupView.picture().isEmpty(), FIRST_PICTURE_TIMEOUT_NS, () -> runIfOpen(stage, () -> {
            looks.apply();
            ColorTheme.style(stage.getScene());
            PaintCallbacks.afterNextPaint(() -> runIfOpen(stage, () -> showLayout(stage, file, startupView.picture())));
        }));
    }

    /** Shows the panes, which say that they wait. */
    private void showLayout(Stage stage, Path file, PictureView picture) {
        var newLayout = new EditorLayout(file, picture);
        stage.getScene().setRoot(newLayout);
        PaintCallbacks.afterNextPaint(() -> runIfOpen(stage, () -> {
            layout = newLayout;
            showIfReady(stage);
        }));
    }

    private static StartupFiles read(FutureTask<StartupFiles> reading) throws Exception {
        // What it holds is for the first document alone.
        startupRead = null;
        try {
            return reading.get();
        } catch (ExecutionException e) {
            switch (e.getCause()) {
                case Exception why -> throw why;
                case Error why -> throw why;
                case Throwable why -> throw new IllegalStateException(why);
            }
        }
    }

    /** How long a scene that is read waits for a first look at it, milliseconds. */
    long previewTimeoutMs() {
        return PREVIEW_TIMEOUT_MS;
    }

    private StartupFiles awaitPreview(StartupFiles files) throws InterruptedException {
        files.preview().await(previewTimeoutMs());
        return files;
    }

    /** Shows what there is to be seen already. */
    private static void showFirstPixels(PictureView picture, StartupFiles files) {
        TracedRaster.Pixels pixels = files.preview().raster().pixels();
        if (pixels != null) {
            picture.setPixels(pixels.width(), pixels.height(), pixels.pixels());
            picture.showNote(TracedPane.coarseNote());
        }
    }

    /** Nobody waits for a scene whose window was closed while it was read. */
    private static void runIfOpen(Stage stage, Runnable action) {
        if (stage.isShowing()) {
            action.run();
        }
    }

    /** Where the scene is read, and the window has its frame. */
    private void showIfReady(Stage stage) {
        StartupFiles files = startupFiles;
        if (files != null && layout != null) {
            startupFiles = null;
            startupSession = new StartupSession(layout, files.document(), files.preview(), preferences, recovery, thread);
            startupSession.whenPainted(() -> runIfOpen(stage, () -> showEditor(stage, files)));
        }
    }

    private void showEditor(Stage stage, StartupFiles files) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        editor = new Editor(stage, startupSession, preferences, thread, FilePrompt.ofSystem(stage), screen.getWidth(), screen.getHeight());
        if (files.failedFile() != null) {
            editor.reportFailedOpen(files.failedFile(), files.failure());
        }
        preloader = new IdlePreloader(stage.getScene(), editor::isIdle, editor.window().preloadSteps().iterator());
        editorOpened(editor);
        editor.offerRecovery(files.findRecoveries());
        if (files.fileToImport() != null) {
            editor.files().load(files.fileToImport());
        }
    }

    /** An editor has its window. */
    void editorOpened(Editor opened) {}

    @Override
    public void stop() {
        if (editor != null) {
            preloader.close();
            editor.close();
        } else if (startupSession != null) {
            startupSession.close();
        }
    }
}
