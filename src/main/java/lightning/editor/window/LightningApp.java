package lightning.editor.window;

import static java.util.Objects.requireNonNull;

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
import lightning.base.Initializer;
import lightning.base.file.ShippedFile;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.document.loop.KeptPictures;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.TracedRaster;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.PictureView;
import org.jspecify.annotations.Nullable;

/**
 * JavaFX application of the editor. Opens in steps: a window with a coarse picture, the layout of all panes, the pane of the traced
 * picture, then all other panes. Reads and previews the scene while the window system starts.
 */
public class LightningApp extends Application {
    /** Task that reads the startup files for the next launch in this process; null unless {@link #open} started it. */
    private static @Nullable FutureTask<StartupFiles> startupRead;

    private static final long PREVIEW_TIMEOUT_MS = 600;
    /** Maximum wait for the first preview before the window shows that it is loading, nanoseconds. */
    private static final long FIRST_PICTURE_TIMEOUT_NS = 300_000_000;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final RecoveryFolder recovery = recovery();
    private Preferences preferences;
    private KeptPictures kept;
    /** Files that were read but are not yet open in an editor; otherwise null. */
    private @Nullable StartupFiles startupFiles;
    /** Null before it is created. */
    private @Nullable EditorLayout layout;
    private @Nullable StartupSession startupSession;
    private @Nullable Editor editor;
    private @Nullable IdlePreloader preloader;
    private boolean isStopped;

    /**
     * Opens the editor and returns when its window is closed. At most once per process.
     *
     * @param arguments the file to open (a scene, or a file that can be imported), or nothing
     * @return reason why no window can be opened, from {@link WindowToolkit#start}; empty on success
     */
    public static Optional<String> open(List<String> arguments) {
        return open(LightningApp.class, arguments);
    }

    static Optional<String> open(Class<? extends LightningApp> program, List<String> arguments) {
        Path file = file(arguments);
        RecoveryFolder recovery = recovery();
        // These preferences are read-only; the application creates its own, writable ones later.
        startupRead = new FutureTask<>(() -> StartupFiles.read(file, new Preferences(EditorPaths.dataFolder(), _ -> {}), recovery));
        Thread.ofPlatform().daemon().name("lightning-opening").start(startupRead);
        Optional<String> problem = WindowToolkit.start();
        if (problem.isEmpty()) {
            launch(program, arguments.toArray(String[]::new));
        }
        return problem;
    }

    /** Returns whether the editor can open a file with this name. */
    public static boolean canOpen(String file) {
        return StartupFiles.canOpen(file);
    }

    /** Returns the file to open; null for the default scene. */
    @Nullable
    Path file() {
        return file(getParameters() == null ? List.of() : getParameters().getUnnamed());
    }

    private static @Nullable Path file(List<String> arguments) {
        return arguments.isEmpty() ? null : ShippedFile.resolve(Path.of(arguments.getFirst()));
    }

    private static RecoveryFolder recovery() {
        return new RecoveryFolder(EditorPaths.dataFolder().resolve("recovery"));
    }

    /** Reads the preferences and the state of the program before a window exists, so that no window has to wait for the disk. */
    @Override
    @Initializer
    public void init() {
        preferences = new Preferences(EditorPaths.dataFolder(), thread);
        kept = KeptPictures.in(EditorPaths.pictureFolder(), !preferences.hasValue("keep-pictures", "false"));
        UiLanguage.activate(preferences);
    }

    @Override
    public void start(Stage stage) {
        Path file = file();
        // Before the window opens: a window without a title is shown with the toolkit's.
        stage.setTitle("Lightning");
        ColorTheme looks = preferences.enumValue("theme", ColorTheme.DARK);
        var startupView = new StartupView(looks, storedLayout());
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

    /** Returns the stored arrangement. A shot's timeline is not known before its file is read. */
    private WindowLayout storedLayout() {
        var stored = new WindowLayout();
        stored.restore(preferences);
        return stored;
    }

    /** Shows the layout with its loading notes. */
    private void showLayout(Stage stage, @Nullable Path file, PictureView picture) {
        var newLayout = new EditorLayout(file == null ? EditorPaths.defaultScene() : file, picture);
        newLayout.reserve(storedLayout());
        stage.getScene().setRoot(newLayout);
        PaintCallbacks.afterNextPaint(() -> runIfOpen(stage, () -> {
            layout = newLayout;
            showIfReady(stage);
        }));
    }

    private static StartupFiles read(FutureTask<StartupFiles> reading) throws Exception {
        // The files are for the first document only.
        startupRead = null;
        try {
            return reading.get();
        } catch (ExecutionException e) {
            switch (requireNonNull(e.getCause())) {
                case Exception why -> throw why;
                case Error why -> throw why;
                case Throwable why -> throw new IllegalStateException(why);
            }
        }
    }

    /** Maximum wait of a loaded scene for its first preview, milliseconds. */
    long previewTimeoutMs() {
        return PREVIEW_TIMEOUT_MS;
    }

    private StartupFiles awaitPreview(StartupFiles files) throws InterruptedException {
        files.preview().await(previewTimeoutMs());
        return files;
    }

    /** Shows the preview if it is ready. */
    private static void showFirstPixels(PictureView picture, StartupFiles files) {
        TracedRaster.Pixels pixels = files.preview().raster().pixels();
        if (pixels != null) {
            picture.setPixels(pixels.width(), pixels.height(), pixels.pixels());
            picture.showNote(TracedPane.coarseNote());
        }
    }

    /** Runs the action only if the window is still open: it may have been closed while the scene was read. */
    private void runIfOpen(Stage stage, Runnable action) {
        if (!isStopped && stage.isShowing()) {
            action.run();
        }
    }

    /** Opens the editor once the scene is read and the window has its layout. */
    private void showIfReady(Stage stage) {
        StartupFiles files = startupFiles;
        if (files != null && layout != null) {
            startupFiles = null;
            OpenDocument document = files.isStartScene() ? files.document().fittedTo(layout.picture().area()) : files.document();
            startupSession = new StartupSession(layout, document, files.preview(), preferences, recovery, thread, kept);
            startupSession.whenPainted(() -> runIfOpen(stage, () -> showEditor(stage, files)));
        }
    }

    private void showEditor(Stage stage, StartupFiles files) {
        Rectangle2D screen = Screen.getPrimary().getVisualBounds();
        Editor opened = new Editor(stage, requireNonNull(startupSession), preferences, thread, FilePrompt.ofSystem(stage),
                screen.getWidth(), screen.getHeight());
        editor = opened;
        opened.model().setBrowser(getHostServices()::showDocument);
        if (files.failedFile() != null && files.failure() != null) {
            opened.reportFailedOpen(files.failedFile(), files.failure());
        }
        opened.files().showNotes();
        preloader = new IdlePreloader(stage.getScene(), opened::isIdle, opened.window().preloadSteps().iterator());
        editorOpened(opened);
        PaintCallbacks.afterNextPaint(files.preview()::endStartup);
        if (files.isStartScene() && files.findRecoveries().isEmpty()) {
            opened.welcome();
        }
        opened.files().offerRecovery(files.findRecoveries());
        if (files.fileToImport() != null) {
            opened.files().load(files.fileToImport());
        }
    }

    /** Called when the editor has its window. Subclasses override it. */
    void editorOpened(Editor opened) {}

    @Override
    public void stop() {
        isStopped = true;
        if (editor != null) {
            requireNonNull(preloader).close();
            editor.close();
        } else if (startupSession != null) {
            startupSession.close();
        }
    }
}
