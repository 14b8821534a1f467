package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Locale;
import lightning.document.FileThread;
import lightning.sample.DefaultLocale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UiLanguageTest {
    private static final String TOOLKIT = "com.sun.javafx.scene.control.skin.resources.controls";

    @TempDir
    private Path folder;

    private String cancel(String requested) throws Exception {
        String before = System.setProperty(UiLanguage.PROPERTY, requested);
        try {
            UiLanguage.activate(new Preferences(folder, new FileThread(Runnable::run)));
            return DefaultLocale.text(TOOLKIT, "Dialog.cancel.button");
        } finally {
            System.setProperty(UiLanguage.PROPERTY, before == null ? "" : before);
            UiLanguage.activate(new Preferences(folder, new FileThread(Runnable::run)));
        }
    }

    @Test
    void toolkitButtons_useEditorLanguage() throws Exception {
        assertThat(DefaultLocale.during(Locale.FRANCE, () -> cancel("english"))).isEqualTo("Cancel");
        assertThat(DefaultLocale.during(Locale.FRANCE, () -> cancel("german"))).isEqualTo("Abbrechen");
    }
}
