package lightning.editor.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import javafx.application.Platform;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.document.loop.KeptPictures;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.model.WorkingSize;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.ColorTheme;
import lightning.format.jen.JenException;
import lightning.scene.light.Light;
import org.testfx.api.FxRobot;
import org.testfx.util.WaitForAsyncUtils;

/** Model of a small scene with a light of each type, for showing single panes. */
public final class TestEditors {
    public static final String SPOT = "key";
    public static final String POINT = "fill";
    public static final String SUN = "sun";
    private static final String TEXT = """
            jen 1
            picture { size 40 30  depth 2 }
            camera { from 0 2 9  to 0 1 0  fov 40 }
            material mirror { diffuse 0.5 0.5 0.5  specular 0.2 0.2 0.2  reflective 0.4 0.4 0.4 }
            plane ground { material mirror  scale 20 1 20 }
            sphere ball { at 0 1 0 }
            light key spot { intensity 1  at 3 5 2  direction -3 -4 -2  angle 25  dropoff 4 }
            light fill point { intensity 0.5  at -3 2 4  attenuation 0.1 1 0.1 }
            light sun directional { intensity 0.3  direction -1 -1 -1  at 1 2 3 }
            """;

    private TestEditors() {}

    /** Creates a model with the first light selected. Call on the window's thread. */
    public static EditorModel model(Path folder) throws IOException, JenException {
        Path file = Files.writeString(folder.resolve("desk.jen"), TEXT);
        return new EditorModel(OpenDocument.open(file), new RecoveryFolder(folder.resolve("recovery")), new FileThread(Platform::runLater));
    }

    /** Starts a session of a scene file on the window's thread. The folder contains preferences and recovered scenes. */
    static StartupSession startupSession(Path file, EditorLayout frame, Path folder, FileThread thread) {
        return startupSession(document(file), frame, new Preferences(folder.resolve("own"), thread),
                new RecoveryFolder(folder.resolve("recovery")),
                thread);
    }

    /** Starts a session of an open document with shared preferences; with Live off, both pictures and the scene's size, unless they have a choice. */
    static StartupSession startupSession(OpenDocument document, EditorLayout frame, Preferences preferences, RecoveryFolder recovery,
            FileThread thread) {
        preferences.set("live", preferences.text("live", "false"));
        preferences.set("working-size", preferences.text("working-size", WorkingSize.SCENE.name()));
        preferences.set("arrangement", preferences.text("arrangement", CanvasLayout.SIDE_BY_SIDE.name()));
        return new StartupSession(frame, document, StartupSession.startPreview(document, preferences), preferences, recovery, thread,
                KeptPictures.none());
    }

    /** Opens a valid scene file. */
    static OpenDocument document(Path file) {
        try {
            return OpenDocument.open(file);
        } catch (IOException | JenException e) {
            throw new AssertionError(e);
        }
    }

    /** Creates a layout with an empty picture. */
    static EditorLayout layout(Path file) {
        return new EditorLayout(file, TracedPane.createView());
    }

    /** Shows a single pane. */
    public static void show(Stage stage, Parent pane) {
        ColorTheme.DARK.apply();
        Scene scene = new Scene(pane, 320, 960);
        ColorTheme.style(scene);
        stage.setScene(scene);
        stage.show();
    }

    public static Light light(EditorModel model, String name) {
        return model.editor().scene().light(name).orElseThrow();
    }

    /** Waits until a node is in a window. Looks it up in the thread that changes windows, because others see them half changed. */
    public static void awaitNode(FxRobot robot, String query) throws TimeoutException {
        await(() -> inWindowThread(() -> robot.lookup(query).tryQuery().isPresent()));
    }

    /** Returns what a query returns in the thread that changes windows; may be called in it. */
    public static <T> T inWindowThread(Callable<T> query) {
        try {
            return Platform.isFxApplicationThread() ? query.call()
                    : WaitForAsyncUtils.asyncFx(query).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    /** Waits until a condition holds. */
    public static void await(BooleanSupplier condition) throws TimeoutException {
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, condition::getAsBoolean);
    }
}
