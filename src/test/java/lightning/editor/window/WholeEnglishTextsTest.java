package lightning.editor.window;

import lightning.base.text.Language;
import lightning.base.text.Texts;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

@Slow
class WholeEnglishTextsTest extends WholeTexts {
    @BeforeAll
    static void speak() {
        Texts.speak(Language.ENGLISH);
    }

    @AfterAll
    static void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    @Test
    void noText_isCut() {
        assertWhole();
    }
}
