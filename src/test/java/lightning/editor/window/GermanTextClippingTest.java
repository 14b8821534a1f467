package lightning.editor.window;

import lightning.base.text.Language;
import lightning.base.text.Messages;
import lightning.sample.Nightly;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** {@link EnglishTextClippingTest} runs in the usual check. */
@Nightly
class GermanTextClippingTest extends TextClippingFixture {
    @BeforeAll
    static void setLanguage() {
        Messages.setLanguage(Language.GERMAN);
    }

    @AfterAll
    static void resetLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void noText_isClipped() {
        assertNotClipped();
    }
}
