package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import org.junit.jupiter.api.Test;

class LinkTableCsvTest {
    private static String csv(String text) throws JenException {
        return new String(LinkTableCsv.of(JenReader.read("jen 1\n" + text, "a", Path.of("")).scene()), StandardCharsets.UTF_8);
    }

    @Test
    void cells_areGains() throws JenException {
        assertThat(csv("""
                group pair { sphere left { }  sphere right { } }
                sphere other { }
                light all point { }
                light one point { illuminates only "left" }
                """)).isEqualTo("""
                object,all,one
                pair,1.0,
                pair/left,1.0,1.0
                pair/right,1.0,0
                other,1.0,0
                """);
    }

    @Test
    void oddNames_areQuoted() throws JenException {
        assertThat(csv("sphere \"a,b\" { }\nlight \"say \\\"x\\\"\" point { }")).isEqualTo("""
                object,"say ""x""\"
                "a,b",1.0
                """);
    }
}
