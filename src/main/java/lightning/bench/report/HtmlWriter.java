package lightning.bench.report;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/** Writer of nested elements and escaped text: well-formed XML that is also HTML. */
final class HtmlWriter {
    private final StringBuilder out = new StringBuilder();
    private final Deque<String> openElements = new ArrayDeque<>();

    /**
     * Opens an element.
     *
     * @param attributes alternating names and values; attributes with a null value are omitted
     */
    HtmlWriter open(String element, @Nullable String... attributes) {
        start(element, attributes);
        out.append('>');
        openElements.push(element);
        return this;
    }

    /** Closes the element opened last. */
    HtmlWriter close() {
        out.append("</").append(openElements.pop()).append(">\n");
        return this;
    }

    /** Writes an element with text content only. */
    HtmlWriter element(String element, String text, @Nullable String... attributes) {
        start(element, attributes);
        out.append('>').append(escape(text)).append("</").append(element).append(">\n");
        return this;
    }

    /** Writes an element without content: {@code img}, {@code input}, {@code meta}. */
    HtmlWriter emptyElement(String element, String... attributes) {
        start(element, attributes);
        out.append("/>\n");
        return this;
    }

    HtmlWriter text(String text) {
        out.append(escape(text));
        return this;
    }

    /** Writes well-formed markup: a chart, the style sheet, the script. */
    HtmlWriter raw(String markup) {
        out.append(markup);
        return this;
    }

    /**
     * Returns the complete text.
     *
     * @throws IllegalStateException if an element is still open
     */
    String finish() {
        if (!openElements.isEmpty()) {
            throw new IllegalStateException("not closed: " + openElements);
        }
        return out.toString();
    }

    private void start(String element, @Nullable String... attributes) {
        out.append('<').append(element);
        for (int i = 0; i < attributes.length; i += 2) {
            if (attributes[i + 1] != null) {
                out.append(' ').append(attributes[i]).append("=\"").append(escape(attributes[i + 1])).append('"');
            }
        }
    }

    /** Escapes text; replaces characters that are invalid in XML with the replacement character. */
    static String escape(String text) {
        StringBuilder escaped = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> escaped.append("&amp;");
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '"' -> escaped.append("&quot;");
                case '\'' -> escaped.append("&#39;");
                default -> escaped.appendCodePoint(isXml(c) ? c : 0xFFFD);
            }
        });
        return escaped.toString();
    }

    private static boolean isXml(int c) {
        return c == '\t' || c == '\n' || c == '\r' || c >= 0x20 && c <= 0xD7FF || c >= 0xE000 && c <= 0xFFFD || c >= 0x10000;
    }
}
