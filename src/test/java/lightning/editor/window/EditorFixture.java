package lightning.editor.window;

import static lightning.editor.window.TestEditors.inWindowThread;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javafx.application.Platform;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.Labeled;
import javafx.stage.Stage;
import javafx.stage.Window;
import lightning.base.math.Vec3;
import lightning.base.work.Await;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.RecoveryFolder;
import lightning.document.manipulation.Viewport;
import lightning.editor.Command;
import lightning.editor.window.command.FilePrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.PanelArrangement;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.preview.PreviewCanvas;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.PictureView;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.Slow;
import lightning.scene.light.Light;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.TestInfo;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;

/**
 * Editor of a small scene with one light of each type, all of them in view.
 *
 * <p>The tests of a class share one editor, which {@link EditorReset} resets before each test, so they pass in any order: it is random, and
 * {@code -Dlightning.seed=N} selects another. A test with {@link OwnEditor} opens and closes an editor of its own.
 */
@ExtendWith(JavaFxRequirement.class)
@TestMethodOrder(MethodOrderer.Random.class)
@Slow
public abstract class EditorFixture {
    private static final String SCENE = """
            jen 1
            picture  { size 64 48  depth 2 }
            camera   { from 0 2 9  to 0 1 0  up 0 1 0  fov 40 }
            world    { ambience 0.2  background 0.1 0.1 0.2 }
            material matt   { ambient 0.1 0.1 0.1  diffuse 0.8 0.7 0.6  specular 0.3 0.3 0.3  shininess 20 }
            material mirror { ambient 0 0 0  diffuse 0.2 0.2 0.2  reflective 0.6 0.6 0.6 }
            plane floor   { material mirror  scale 12 1 12 }
            sphere ball   { material matt  at 0 1 0 }
            light lamp point { at -2 2.2 0.5  intensity 1 }
            light sun directional { at 0 2.8 0  direction 0.3 -1 -0.4  intensity 0.4 }
            light stage spot { at 2 2.2 0.5  direction -2 -1.5 -0.5  angle 30  intensity 1.5 }
            """;

    /** Distance of the mouse from the window's lower right corner between tests, pixels. */
    private static final double CORNER = 8;

    /** Folder of the shared editors' preferences. */
    @TempDir
    static Path sharedFolder;

    private static OpenEditor shared;
    private static EditorFixture current;

    @TempDir
    public Path folder;

    public final FxRobot robot = new FastRobot();
    Stage stage;
    public Editor editor;
    /** File that the file dialogs return; null cancels them. */
    public volatile Path answer;
    /** Folder that the last dialog for a scene to open started in; null before the first. */
    public volatile Path openedFolder;

    /** Returns the text of the scene that the editor opens. */
    protected String sceneText() {
        return SCENE;
    }

    /**
     * Editor with its window.
     *
     * @param initial window and settings that each test starts with
     */
    private record OpenEditor(Stage stage, Editor editor, EditorReset initial) {}

    @BeforeEach
    final void prepareEditor(TestInfo test) throws Exception {
        current = this;
        if (OwnEditor.Uses.isUsedBy(test)) {
            closeShared();
            open();
        } else if (shared == null) {
            // Without the settings of an earlier shared editor.
            open(Files.createTempDirectory(sharedFolder, "settings"));
            shared = new OpenEditor(stage, editor, EditorReset.of(stage, editor));
        } else {
            stage = shared.stage();
            editor = shared.editor();
            OpenDocument document = TestEditors.document(writeScene());
            FxToolkit.setupFixture(() -> shared.initial().restore(document));
            waitForPicture();
        }
    }

    /** Opens an editor. */
    void open() throws Exception {
        open(folder);
    }

    private void open(Path settings) throws Exception {
        FxToolkit.registerPrimaryStage();
        Path file = writeScene();
        FxToolkit.setupFixture(() -> {
            ColorTheme.DARK.apply();
            stage = new Stage();
            var thread = new FileThread(Platform::runLater);
            var preferences = new Preferences(settings.resolve("own"), thread);
            var sight = TestEditors.startupSession(TestEditors.document(file), TestEditors.layout(file), preferences,
                    new RecoveryFolder(EditorPaths.dataFolder().resolve("recovery")), thread);
            editor = new Editor(stage, sight, preferences, thread, new PromptAnswers(), 1000, 700);
        });
        waitForPicture();
    }

    private Path writeScene() throws IOException {
        return Files.writeString(folder.resolve("desk.jen"), sceneText());
    }

    @AfterEach
    final void leaveEditor() throws Exception {
        robot.release(new javafx.scene.input.MouseButton[0]);
        robot.release(new javafx.scene.input.KeyCode[0]);
        if (shared == null) {
            close();
        } else {
            FxToolkit.setupFixture(shared.initial()::hideOtherWindows);
            FastRobot.settle();
            // So that a click there and a click of the next test are no double click.
            robot.moveTo(stage.getX() + stage.getWidth() - CORNER, stage.getY() + stage.getHeight() - CORNER);
        }
    }

    /** Closes the editor. */
    void close() throws Exception {
        FxToolkit.setupFixture(() -> {
            editor.close();
            stage.close();
        });
    }

    @AfterAll
    static void closeShared() throws Exception {
        if (shared != null) {
            OpenEditor open = shared;
            shared = null;
            FxToolkit.setupFixture(() -> {
                open.editor().close();
                open.stage().close();
            });
        }
    }

    private static final class PromptAnswers implements FilePrompt {
        @Override
        public Optional<Path> sceneToOpen(Path from) {
            current.openedFolder = from;
            return Optional.ofNullable(current.answer);
        }

        @Override
        public Optional<Path> sceneToWrite(Path proposal) {
            return Optional.ofNullable(current.answer);
        }

        @Override
        public Optional<Path> pictureToWrite(Path proposal) {
            return Optional.ofNullable(current.answer);
        }
    }

    public EditorModel model() {
        return editor.model();
    }

    public Light light(String name) {
        return model().editor().scene().light(name).orElseThrow();
    }

    /** Waits until a condition holds on the window's thread and the window is laid out. */
    public void waitFor(String description, Callable<Boolean> condition) {
        try {
            WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS,
                    () -> WaitForAsyncUtils.asyncFx(condition).get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS));
        } catch (TimeoutException e) {
            throw new AssertionError("waited " + Await.TIMEOUT_SECONDS + " s until " + description, e);
        }
        FastRobot.settle();
    }

    /** Waits until the picture is complete. */
    public void waitForPicture() {
        waitFor("the picture is shown", () -> !model().editor().editorStateProperty().get().hasPendingEdits()
                && model().editor().editorStateProperty().get().sceneInProgress().isEmpty());
    }

    /** Clicks the control with an id. */
    public void click(String id) {
        robot.clickOn("#" + id);
    }

    public boolean isEnabled(Command command) {
        return inWindowThread(() -> !robot.lookup("#" + command.id()).<Node>query().isDisabled());
    }

    public String text(String id) {
        return inWindowThread(() -> robot.lookup("#" + id).<Labeled>query().getText());
    }

    /** Returns the details of the last update in one line. */
    public String telemetry() {
        return inWindowThread(() -> robot.lookup("#status").<javafx.scene.control.Button>query().getTooltip().getText());
    }

    public boolean isShown(String id) {
        return inWindowThread(() -> robot.lookup("#" + id).tryQuery().map(Node::isVisible).orElse(false));
    }

    public PreviewCanvas preview() {
        return inWindowThread(() -> robot.lookup("#preview-canvas").query());
    }

    /** Returns the screen position of a scene point in the preview. */
    public Point2D toScreen(Vec3 point) {
        Viewport canvas = preview().viewport();
        return preview().toScreen(canvas.project(model().previewSettings().cameraProperty().get(), point));
    }

    /** Makes all panels open in windows of their own. */
    public void floatPanels() {
        robot.interact(() -> {
            PanelArrangement floating = PanelArrangement.INITIAL;
            for (PanelArrangement.Slot slot : PanelArrangement.INITIAL.slots()) {
                floating = floating.move(slot.panel(), PanelPlace.WINDOW);
            }
            model().layout().panelsProperty().set(floating.closeAll());
        });
    }

    /** Closes all panels, docked or not, and all secondary windows. */
    public void closePanels() {
        robot.interact(() -> {
            model().layout().panelsProperty().set(model().layout().panelsProperty().get().closeAll());
            List.copyOf(Window.getWindows()).stream().filter(w -> w != stage).forEach(Window::hide);
        });
    }

    /** Asserts that every displayed pixel of the canvas equals that of a film. */
    public void assertCanvasShows(lightning.render.image.Film expected) {
        int[] shown = inWindowThread(() -> robot.lookup("#traced-picture").<PictureView>query().pixels());
        assertThat(shown).as("the pixels of the canvas").isEqualTo(model().picture().viewProperty().get().toPixels(expected));
    }

    /** Asserts that Go with current reflections renders the same pixels as the reference tracer. */
    public void assertGoShowsTheScene() {
        click("go");
        waitForPicture();
        robot.interact(() -> model().commands().run(Command.UPDATE_REFLECTIONS));
        waitFor("the mirrors are current", () -> !model().commands().isEnabled(Command.UPDATE_REFLECTIONS)
                && model().editor().editorStateProperty().get().sceneInProgress().isEmpty());
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
    }

    public void assertFilmIs(lightning.render.image.Film expected) {
        assertThat(model().picture().frame().film().hasSameBits(expected)).as("every bit of the picture").isTrue();
    }
}
