package lightning.format.exr;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class ExrHeaderTest {
    private static byte[] encoded(List<String> names) {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        names.forEach(name -> attributes.put(name, new ExrAttribute.Text("value of " + name)));
        return ExrHeader.encode(List.of(new ExrHeader(4, 4, List.of(new ExrChannel("R", ExrType.HALF)), attributes)));
    }

    @Test
    void bytes_doNotDependOnOrderOfAttributes() {
        List<String> names = List.of("software", "lightning/sum", "lightning/lights", "lightning/shapes", "lightning/materials");
        assertThat(
                Stream.of(names, names.reversed(), names.stream().sorted(Collections.reverseOrder()).toList()).map(ExrHeaderTest::encoded))
                .allSatisfy(bytes -> assertThat(bytes).isEqualTo(encoded(names)));
    }
}
