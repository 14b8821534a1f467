package lightning.base.text;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Parser of gettext catalogs ({@code .po}): entries of {@code msgid} and {@code msgstr} with continuation lines and the escapes
 * {@code \n}, {@code \t}, {@code \"} and {@code \\}. Entries marked {@code fuzzy} and those without a translation are skipped.
 * Contexts and plural forms are not supported.
 */
final class PoParser {
    private static final String ID = "msgid ";
    private static final String TRANSLATION = "msgstr ";

    private final String content;
    private final Map<String, String> translations = new HashMap<>();
    private @Nullable StringBuilder id;
    private @Nullable StringBuilder translation;
    private boolean isFuzzy;
    private int line;

    PoParser(String content) {
        this.content = content;
    }

    /**
     * Returns the translations by their English texts, without the header.
     *
     * @throws IllegalArgumentException with the line number, if a line is none of the above or an English text occurs twice
     */
    Map<String, String> parse() {
        boolean nextIsFuzzy = false;
        for (String text : content.lines().toList()) {
            line++;
            if (text.startsWith("#,") && text.contains("fuzzy")) {
                nextIsFuzzy = true;
            } else if (text.startsWith(ID)) {
                store();
                id = new StringBuilder(unquote(text.substring(ID.length())));
                isFuzzy = nextIsFuzzy;
                nextIsFuzzy = false;
            } else if (text.startsWith(TRANSLATION) && id != null && translation == null) {
                translation = new StringBuilder(unquote(text.substring(TRANSLATION.length())));
            } else if (text.startsWith("\"") && id != null) {
                (translation == null ? id : translation).append(unquote(text));
            } else if (!text.isBlank() && !text.startsWith("#")) {
                throw problem("expected msgid, msgstr or a quoted text, found " + Quote.of(text));
            }
        }
        store();
        return Map.copyOf(translations);
    }

    private void store() {
        if (id == null) {
            return;
        }
        if (translation == null) {
            throw problem("expected msgstr for " + Quote.of(id.toString()));
        }
        if (!id.isEmpty() && !translation.isEmpty() && !isFuzzy && translations.put(id.toString(), translation.toString()) != null) {
            throw problem("duplicate msgid " + Quote.of(id.toString()));
        }
        id = null;
        translation = null;
    }

    private String unquote(String quoted) {
        if (quoted.length() < 2 || !quoted.startsWith("\"") || !quoted.endsWith("\"")) {
            throw problem("expected a text in quotes, found " + Quote.of(quoted));
        }
        var text = new StringBuilder();
        for (int i = 1; i < quoted.length() - 1; i++) {
            char c = quoted.charAt(i);
            text.append(c == '\\' && i + 1 < quoted.length() - 1 ? escaped(quoted.charAt(++i)) : c);
        }
        return text.toString();
    }

    private char escaped(char c) {
        return switch (c) {
            case 'n' -> '\n';
            case 't' -> '\t';
            case '"', '\\' -> c;
            default -> throw problem("unknown escape \\" + c);
        };
    }

    private IllegalArgumentException problem(String message) {
        return new RefusalException("line " + line + ": " + message);
    }
}
