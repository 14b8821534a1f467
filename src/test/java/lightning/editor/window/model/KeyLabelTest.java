package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class KeyLabelTest {
    @AfterEach
    void english() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private static String label(Language language, String key) {
        Messages.setLanguage(language);
        return new KeyLabel(KeyCombination.valueOf(key)).getDisplayText();
    }

    @Test
    void english_matchesToolkit() {
        assertThat(label(Language.ENGLISH, "Shortcut+Shift+P")).isEqualTo(KeyCombination.valueOf("Shortcut+Shift+P").getDisplayText());
        assertThat(label(Language.ENGLISH, "Shortcut+Delete")).isEqualTo("Ctrl+Delete");
    }

    @Test
    void german_usesStrg() {
        assertThat(label(Language.GERMAN, "Shortcut+Z")).isEqualTo("Strg+Z");
        assertThat(label(Language.GERMAN, "Shortcut+Alt+Shift+Z")).matches("(Umschalt\\+|Strg\\+|Alt\\+){3}Z");
        assertThat(label(Language.GERMAN, "Shortcut+Delete")).isEqualTo("Strg+Entf");
        assertThat(label(Language.GERMAN, "F5")).isEqualTo("F5");
    }

    @Test
    void match_acceptsOnlyThatKey() {
        var key = new KeyLabel(KeyCombination.valueOf("Ctrl+Z"));
        assertThat(key.match(event(KeyCode.Z, true))).isTrue();
        assertThat(key.match(event(KeyCode.Z, false))).isFalse();
        assertThat(key.match(event(KeyCode.Y, true))).isFalse();
    }

    private static KeyEvent event(KeyCode code, boolean control) {
        return new KeyEvent(KeyEvent.KEY_PRESSED, "", "", code, false, control, false, false);
    }

    @Test
    void escape_isNamedAsOnTheKey() {
        assertThat(KeyLabel.text(KeyCombination.valueOf("Esc"))).isEqualTo("Esc");
    }
}
