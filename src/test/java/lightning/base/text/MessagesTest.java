package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class MessagesTest {
    @AfterEach
    void resetLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void english_isUntranslated() {
        assertThat(Messages.tr("Imported {0}", "a")).isEqualTo("Imported a");
        assertThat(Messages.tr("no such text")).isEqualTo("no such text");
    }

    @Test
    void german_comesFromTheBundle() {
        Messages.setLanguage(Language.GERMAN);
        assertThat(Messages.tr("Imported {0}", "a {0}")).isEqualTo("a {0} importiert");
        assertThat(Messages.tr("no such text")).isEqualTo("no such text");
    }

    @Test
    void placeholders_areFilledInAnyOrder() {
        assertThat(Messages.tr("{1} {0} {1} {2} {x} {", "a", 2)).isEqualTo("2 a 2 {2} {x} {");
        assertThat(Messages.tr("{0}")).isEqualTo("{0}");
    }

    @Test
    void count_selectsSingularOrPlural() {
        Messages.setLanguage(Language.GERMAN);
        assertThat(Messages.count(1, "Switched off 1 light: ", "Switched off {0} lights: ", 1)).isEqualTo("1 Licht ausgeschaltet: ");
        assertThat(Messages.count(0, "Switched off 1 light: ", "Switched off {0} lights: ", 0)).isEqualTo("0 Lichter ausgeschaltet: ");
    }

    @Test
    void unsupportedSystemLanguage_isEnglish() {
        assertThat(Language.forSystem("de")).isEqualTo(Language.GERMAN);
        assertThat(Language.forSystem("fr")).isEqualTo(Language.ENGLISH);
        assertThat(Language.forSystem("")).isEqualTo(Language.ENGLISH);
    }
}
