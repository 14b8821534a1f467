package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;
import lightning.base.text.Language;
import lightning.base.text.Texts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class SpokenKeyTest {
    @AfterEach
    void english() {
        Texts.speak(Language.ENGLISH);
    }

    private static String spoken(Language language, String key) {
        Texts.speak(language);
        return new SpokenKey(KeyCombination.valueOf(key)).getDisplayText();
    }

    @Test
    void english_isWhatTheToolkitWrites() {
        assertThat(spoken(Language.ENGLISH, "Shortcut+Shift+P")).isEqualTo(KeyCombination.valueOf("Shortcut+Shift+P").getDisplayText());
        assertThat(spoken(Language.ENGLISH, "Shortcut+Delete")).isEqualTo("Ctrl+Delete");
    }

    @Test
    void german_saysStrgAsItsTextsDo() {
        assertThat(spoken(Language.GERMAN, "Shortcut+Z")).isEqualTo("Strg+Z");
        assertThat(spoken(Language.GERMAN, "Shortcut+Alt+Shift+Z")).matches("(Umschalt\\+|Strg\\+|Alt\\+){3}Z");
        assertThat(spoken(Language.GERMAN, "Shortcut+Delete")).isEqualTo("Strg+Entf");
        assertThat(spoken(Language.GERMAN, "F5")).isEqualTo("F5");
    }

    @Test
    void pressed_isThatKeyAlone() {
        var key = new SpokenKey(KeyCombination.valueOf("Ctrl+Z"));
        assertThat(key.match(event(KeyCode.Z, true))).isTrue();
        assertThat(key.match(event(KeyCode.Z, false))).isFalse();
        assertThat(key.match(event(KeyCode.Y, true))).isFalse();
    }

    private static KeyEvent event(KeyCode code, boolean control) {
        return new KeyEvent(KeyEvent.KEY_PRESSED, "", "", code, false, control, false, false);
    }
}
