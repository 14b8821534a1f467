package lightning.format.ocio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class OcioReferenceTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "ocio | env.ocio | ''",
        "ocio: | env.ocio | ''",
        "ocio:sRGB - Display/Raw | env.ocio | sRGB - Display/Raw",
        "ocio:show.ocio#sRGB/Raw | show.ocio | sRGB/Raw",
        "ocio:show.ocio#a#b | show.ocio | a#b",
        "ocio:show.ocio# | show.ocio | ''",
        "ocio://default | ocio://default | ''",
        "ocio://default#sRGB/Raw | ocio://default | sRGB/Raw",
        "ocio:ocio://default#sRGB/Raw | ocio://default | sRGB/Raw"})
    void text_hasConfigurationAndView(String text, String config, String view) throws IOException {
        assertThat(OcioReference.isReference(text)).isTrue();
        assertThat(OcioReference.parse(text, "env.ocio")).isEqualTo(new OcioReference(config, view));
    }

    @ParameterizedTest
    @ValueSource(strings = {"ociolook.cube", "filmic", "", "OCIO:a"})
    void otherText_isNoReference(String text) {
        assertThat(OcioReference.isReference(text)).isFalse();
    }

    @Test
    void noConfiguration_isOneSentence() {
        for (String environment : new String[] {null, ""}) {
            assertThatThrownBy(() -> OcioReference.parse("ocio:sRGB/Raw", environment)).isInstanceOf(IOException.class).hasMessage(
                    "OpenColorIO: expected a configuration, found none; set the environment variable OCIO, or name a file or ocio://default");
        }
    }
}
