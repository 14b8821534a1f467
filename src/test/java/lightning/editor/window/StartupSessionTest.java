package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import javafx.application.Platform;
import javafx.stage.Stage;
import lightning.base.work.Await;
import lightning.document.FileThread;
import lightning.editor.window.model.Preferences;
import lightning.render.image.CubeLut;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxToolkit;
import org.testfx.util.WaitForAsyncUtils;

@ExtendWith(JavaFxRequirement.class)
@Slow
class StartupSessionTest {
    @TempDir
    private Path folder;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final AtomicReference<Boolean> seen = new AtomicReference<>();
    private Stage stage;
    private StartupSession startupSession;

    @BeforeEach
    void register() throws Exception {
        FxToolkit.registerPrimaryStage();
    }

    @AfterEach
    void close() throws Exception {
        FxToolkit.setupFixture(() -> {
            // None if the test was skipped.
            if (startupSession != null) {
                startupSession.close();
                stage.close();
            }
        });
        thread.close();
    }

    /** Shows the pane of a picture, and records whether the picture was drawn when the callback ran. */
    private void show(String size) throws Exception {
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { size " + size + " }\nsphere ball { }\n");
        FxToolkit.setupFixture(() -> {
            stage = new Stage();
            startupSession = TestEditors.startupSession(file, TestEditors.layout(file), folder, thread);
            TestEditors.show(stage, startupSession.frame());
            startupSession.whenPainted(() -> seen.set(!startupSession.traced().isEmpty()));
        });
    }

    @Test
    void restOfWindow_waitsForPicture() throws Exception {
        show("40 30");
        TestEditors.await(() -> seen.get() != null);
        assertThat(seen.get()).isTrue();
    }

    @Test
    void restOfWindow_withoutPicture_doesNotWait() throws Exception {
        show("16384 16384");
        TestEditors.await(() -> seen.get() != null);
        assertThat(seen.get()).isFalse();
    }

    @Test
    void colorTable_afterRestart_isRestored() throws Exception {
        Path table = Files.writeString(folder.resolve("look.cube"), "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        var preferences = new Preferences(folder.resolve("own"), Runnable::run);
        preferences.set("table", table);
        preferences.save();
        show("16 12");
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS,
                () -> WaitForAsyncUtils.asyncFx(() -> startupSession.model().picture().viewProperty().get().lut().isPresent()).get());
    }

    @Test
    void missingColorTable_showsMessage() throws Exception {
        var preferences = new Preferences(folder.resolve("own"), Runnable::run);
        preferences.set("table", folder.resolve("gone.cube"));
        preferences.save();
        show("16 12");
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS,
                () -> WaitForAsyncUtils
                        .asyncFx(() -> startupSession.model().editor().message().textProperty().get().contains("file not found"))
                        .get());
        assertThat(startupSession.model().picture().viewProperty().get().lut()).isEmpty();
    }

    @Test
    void viewOfOpenColorIo_afterRestart_isMadeAgain() throws Exception {
        PythonPrograms.require("PyOpenColorIO");
        var preferences = new Preferences(folder.resolve("own"), Runnable::run);
        preferences.set("ocio.config", "ocio://default");
        preferences.set("ocio.view", "sRGB - Display/Un-tone-mapped");
        preferences.save();
        show("16 12");
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, () -> WaitForAsyncUtils
                .asyncFx(() -> startupSession.model().picture().viewProperty().get().lut().flatMap(CubeLut::log).isPresent()).get());
    }

    @Test
    void missingConfigurationOfOpenColorIo_showsMessage() throws Exception {
        PythonPrograms.require("PyOpenColorIO");
        var preferences = new Preferences(folder.resolve("own"), Runnable::run);
        preferences.set("ocio.config", folder.resolve("gone.ocio"));
        preferences.save();
        show("16 12");
        WaitForAsyncUtils.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS, () -> WaitForAsyncUtils
                .asyncFx(() -> startupSession.model().editor().message().textProperty().get().contains("gone.ocio: file not found")).get());
        assertThat(startupSession.model().picture().viewProperty().get().lut()).isEmpty();
    }
}
