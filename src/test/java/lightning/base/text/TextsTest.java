package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class TextsTest {
    @AfterEach
    void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    @Test
    void english_isItsOwnWords() {
        assertThat(Texts.of("Imported {0}", "a")).isEqualTo("Imported a");
        assertThat(Texts.of("no such text")).isEqualTo("no such text");
    }

    @Test
    void german_isTheBundlesWords() {
        Texts.speak(Language.GERMAN);
        assertThat(Texts.of("Imported {0}", "a {0}")).isEqualTo("a {0} importiert");
        assertThat(Texts.of("no such text")).isEqualTo("no such text");
    }

    @Test
    void values_standInAnyOrderAndWhatIsNoneStays() {
        assertThat(Texts.of("{1} {0} {1} {2} {x} {", "a", 2)).isEqualTo("2 a 2 {2} {x} {");
        assertThat(Texts.of("{0}")).isEqualTo("{0}");
    }

    @Test
    void number_choosesTheWords() {
        Texts.speak(Language.GERMAN);
        assertThat(Texts.count(1, "Switched off 1 light: ", "Switched off {0} lights: ", 1)).isEqualTo("1 Licht ausgeschaltet: ");
        assertThat(Texts.count(0, "Switched off 1 light: ", "Switched off {0} lights: ", 0)).isEqualTo("0 Lichter ausgeschaltet: ");
    }

    @Test
    void systemOfAnotherLanguage_hearsEnglish() {
        assertThat(Language.ofSystem("de")).isEqualTo(Language.GERMAN);
        assertThat(Language.ofSystem("fr")).isEqualTo(Language.ENGLISH);
        assertThat(Language.ofSystem("")).isEqualTo(Language.ENGLISH);
    }

    @Test
    void bundle_readsLinesAndNewLines() {
        assertThat(TextBundle.read("# note\na\\nb\n    c\\nd\n\n\ne \n    f ")).containsOnly(
                java.util.Map.entry("a\nb", "c\nd"), java.util.Map.entry("e ", "f "));
    }

    @Test
    void wordsTwiceOrWithoutEnglish_areRefused() {
        assertThatThrownBy(() -> TextBundle.read("a\n    b\na\n    c")).hasMessageContaining("no English words");
        assertThatThrownBy(() -> TextBundle.read("    b")).hasMessageContaining("no English words");
    }
}
