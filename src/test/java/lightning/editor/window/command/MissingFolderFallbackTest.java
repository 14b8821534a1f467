package lightning.editor.window.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class MissingFolderFallbackTest {
    private static final File CHOSEN = new File("chosen");

    @Test
    void existingFolder_isUsed() {
        List<File> folders = new ArrayList<>();
        assertThat(MissingFolderFallback.show(folders::add, () -> CHOSEN)).isEqualTo(CHOSEN);
        assertThat(folders).isEmpty();
    }

    @Test
    void missingFolder_usesSystemDefault() {
        List<File> folders = new ArrayList<>();
        File chosen = MissingFolderFallback.show(folders::add, () -> {
            // As JavaFX does.
            if (folders.isEmpty()) {
                throw new IllegalArgumentException("Folder parameter must be a valid folder");
            }
            return CHOSEN;
        });
        assertThat(chosen).isEqualTo(CHOSEN);
        assertThat(folders).containsExactly((File) null);
    }
}
