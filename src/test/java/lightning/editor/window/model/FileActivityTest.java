package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class FileActivityTest {
    private final FileActivity activity = new FileActivity(() -> {});
    private final Path file = Path.of("chair.glb");

    @Test
    void nextStep_isShownByItsTitle() {
        activity.beginReading(file);
        assertThat(activity.titleProperty().get()).isEqualTo("Reading");
        activity.setTitle(file, "Previewing");
        assertThat(activity.titleProperty().get()).isEqualTo("Previewing");
    }

    @Test
    void stepOfCanceledFile_doesNotRenameNextActivity() {
        activity.beginReading(file);
        Path other = Path.of("table.exr");
        activity.beginWriting(other);
        activity.setTitle(file, "Previewing");
        assertThat(activity.titleProperty().get()).isEqualTo("Writing");
    }
}
