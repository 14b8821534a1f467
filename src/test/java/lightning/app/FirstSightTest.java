package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicReference;
import javafx.application.Platform;
import javafx.stage.Stage;
import lightning.app.model.Preferences;
import lightning.edit.FileThread;
import lightning.edit.OpenDocument;
import lightning.edit.Recovery;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxToolkit;

@ExtendWith(JavaFxNeeds.class)
class FirstSightTest {
    @TempDir
    private Path folder;

    private final FileThread thread = new FileThread(Platform::runLater);
    private final AtomicReference<Boolean> seen = new AtomicReference<>();
    private Stage stage;
    private FirstSight sight;

    @BeforeEach
    void register() throws Exception {
        FxToolkit.registerPrimaryStage();
    }

    @AfterEach
    void close() throws Exception {
        FxToolkit.setupFixture(() -> {
            sight.close();
            stage.close();
        });
        thread.close();
    }

    /** Shows the pane of a picture, and asks to hear when it is seen: whether there was one then. */
    private void show(String size) throws Exception {
        Path file = Files.writeString(folder.resolve("scene.jen"), "jen 1\npicture { size " + size + " }\nsphere ball { }\n");
        FxToolkit.setupFixture(() -> {
            stage = new Stage();
            try {
                sight = new FirstSight(new EditorFrame(file), OpenDocument.open(file), new Preferences(folder.resolve("own"), thread),
                        new Recovery(folder.resolve("recovery")), thread);
            } catch (Exception e) {
                throw new AssertionError(e);
            }
            OpenEditor.show(stage, sight.frame());
            sight.whenSeen(() -> seen.set(!sight.traced().isEmpty()));
        });
    }

    @Test
    void restOfTheWindow_waitsForThePicture() throws Exception {
        show("40 30");
        OpenEditor.await(() -> seen.get() != null);
        assertThat(seen.get()).isTrue();
    }

    @Test
    void restOfTheWindow_doesNotWaitForAPictureThatCannotBe() throws Exception {
        show("16384 16384");
        OpenEditor.await(() -> seen.get() != null);
        assertThat(seen.get()).isFalse();
    }
}
