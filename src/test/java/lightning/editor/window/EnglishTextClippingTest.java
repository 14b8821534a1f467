package lightning.editor.window;

import lightning.base.text.Language;
import lightning.base.text.Messages;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

@Slow
class EnglishTextClippingTest extends TextClippingFixture {
    @BeforeAll
    static void setLanguage() {
        Messages.setLanguage(Language.ENGLISH);
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
