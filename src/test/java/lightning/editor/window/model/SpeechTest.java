package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Locale;
import lightning.editor.document.FileThread;
import lightning.sample.DefaultLocale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SpeechTest {
    private static final String TOOLKIT = "com.sun.javafx.scene.control.skin.resources.controls";

    @TempDir
    private Path folder;

    private String cancel(String asked) throws Exception {
        String before = System.setProperty(Speech.PROPERTY, asked);
        try {
            Speech.begin(new Preferences(folder, new FileThread(Runnable::run)));
            return DefaultLocale.text(TOOLKIT, "Dialog.cancel.button");
        } finally {
            System.setProperty(Speech.PROPERTY, before == null ? "" : before);
            Speech.begin(new Preferences(folder, new FileThread(Runnable::run)));
        }
    }

    @Test
    void toolkitsOwnButtons_speakAsTheEditorDoes() throws Exception {
        assertThat(DefaultLocale.during(Locale.FRANCE, () -> cancel("english"))).isEqualTo("Cancel");
        assertThat(DefaultLocale.during(Locale.FRANCE, () -> cancel("german"))).isEqualTo("Abbrechen");
    }
}
