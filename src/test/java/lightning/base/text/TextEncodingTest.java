package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

class TextEncodingTest {

    @Property
    void utf8_isDecoded(@ForAll String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        assertThat(TextEncoding.decode(bytes)).isEqualTo(new String(bytes, StandardCharsets.UTF_8));
    }

    @Test
    void otherBytes_areWindows1252() {
        assertThat(TextEncoding.decode("Tür".getBytes(StandardCharsets.ISO_8859_1))).isEqualTo("Tür");
        assertThat(TextEncoding.decode(new byte[] {(byte) 0x80, 'a', (byte) 0xE9})).isEqualTo("€aé");
        assertThat(TextEncoding.decode(new byte[] {(byte) 0xC3, (byte) 0xBC, (byte) 0xFC, ' ', (byte) 0xE2, (byte) 0x82}))
                .isEqualTo("üü â‚");
    }

    @Property
    void anyBytes_areDecoded(@ForAll byte[] bytes) {
        assertThat(TextEncoding.decode(bytes).length()).isLessThanOrEqualTo(bytes.length);
    }
}
