package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import lightning.base.text.Language;
import lightning.base.text.Texts;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What an editor in German says of other machines. */
class SentencesTest {
    @BeforeEach
    void speakGerman() {
        Texts.speak(Language.GERMAN);
    }

    @AfterEach
    void speakEnglish() {
        Texts.speak(Language.ENGLISH);
    }

    @Test
    void wordsThatNameNoMachine_areRefusedInGerman() {
        assertThatThrownBy(() -> HostPort.of("a:99999")).isInstanceOf(IllegalArgumentException.class).hasMessageStartingWith("ein Rechner");
    }

    @Test
    void certificateThatIsNotThere_isToldInGerman() {
        Path none = Path.of("none.p12");
        assertThatThrownBy(() -> SharedKey.context(none)).isInstanceOf(JoinException.class)
                .hasMessageContaining("diese Datei gibt es nicht");
    }
}
