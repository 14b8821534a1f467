package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests German messages about other machines. */
class GermanErrorsTest {
    @BeforeEach
    void setGerman() {
        Messages.setLanguage(Language.GERMAN);
    }

    @AfterEach
    void resetLanguage() {
        Messages.setLanguage(Language.ENGLISH);
    }

    @Test
    void invalidHost_isRejectedInGerman() {
        assertThatThrownBy(() -> HostPort.parse("a:99999")).isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("Rechner und Port");
    }

    @Test
    void missingCertificate_isReportedInGerman() {
        Path none = Path.of("none.p12");
        assertThatThrownBy(() -> ClusterCertificate.sslContext(none)).isInstanceOf(JoinException.class)
                .hasMessageContaining("Datei nicht gefunden");
    }
}
