package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.StringReader;
import javax.xml.parsers.DocumentBuilderFactory;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.xml.sax.InputSource;

class HtmlWriterTest {

    @Property
    void anyText_roundTrips(@ForAll String text) throws Exception {
        String page = new HtmlWriter().open("p", "title", text).text(text).close().finish();
        Element p = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(page)))
                .getDocumentElement();

        assertThat(p.getTextContent()).isEqualTo(xmlCharacters(text).replace("\r\n", "\n").replace('\r', '\n'));
        assertThat(p.getAttribute("title")).isEqualTo(xmlCharacters(text).replace("\r\n", " ").replaceAll("[\r\n\t]", " "));
    }

    /** Returns the characters that XML allows. */
    private static String xmlCharacters(String text) {
        return text.codePoints().map(c -> c == '\t' || c == '\n' || c == '\r' || c >= 0x20 && c <= 0xD7FF || c >= 0xE000 && c <= 0xFFFD
                || c >= 0x10000 ? c : 0xFFFD).collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append).toString();
    }

    @Test
    void markupInText_isEscaped() {
        assertThat(new HtmlWriter().element("b", "<script>\"&'").finish()).isEqualTo("<b>&lt;script&gt;&quot;&amp;&#39;</b>\n");
    }

    @Test
    void nullAttribute_isOmitted() {
        assertThat(new HtmlWriter().emptyElement("input", "class", null, "type", "range").finish()).isEqualTo("<input type=\"range\"/>\n");
    }

    @Test
    void openElement_failsOnFinish() {
        HtmlWriter page = new HtmlWriter().open("div").open("p").close();

        assertThatThrownBy(page::finish).isInstanceOf(IllegalStateException.class).hasMessageContaining("div");
    }
}
