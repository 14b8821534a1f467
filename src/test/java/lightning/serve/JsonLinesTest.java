package lightning.serve;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests of messages that are not one JSON object. */
class JsonLinesTest {
    private static String message(String line) {
        return catchThrowableOfType(RequestException.class, () -> JsonLines.parse(line.getBytes(UTF_8))).getMessage();
    }

    @Test
    void secondObject_isNamed() {
        assertThat(message("{\"id\":1} {\"id\":2}")).contains("found more after the first");
    }

    @Test
    void limits_areNamed() {
        assertThat(message("[".repeat(100))).contains("at most 8 levels deep");
        assertThat(message("{\"id\":" + "1".repeat(100) + "}")).contains("numbers of at most 40 characters");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"{", "{\"a\":1,\"a\":2}", "{\"a\":}", "nul", "{'a':1}", "{\"a\":\"\u0001\"}", "{\"id\":1}{", "[[[[[[[[[[", "\u0000"})
    void noMessage_namesJavaClasses(String line) {
        assertThat(message(line)).startsWith("expected one JSON object a line").doesNotContainPattern("[A-Z][a-z]+[A-Z][a-z]+");
    }
}
