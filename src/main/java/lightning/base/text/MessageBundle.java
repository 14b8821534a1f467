package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * Translations of one language, from a UTF-8 file next to this class: a line with the English text and below it, indented by four spaces,
 * the translation. {@code \n} is a line break. Empty lines and lines that begin with {@code #} are ignored.
 */
final class MessageBundle {
    private static final String INDENT = "    ";

    private MessageBundle() {
    }

    /** Loads a language's texts by their English text. */
    static Map<String, String> load(Language language) {
        if (language.bundle().isEmpty()) {
            return Map.of();
        }
        try (InputStream in = MessageBundle.class.getResourceAsStream(language.bundle())) {
            return parse(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Parses a bundle.
     *
     * @throws IllegalArgumentException if an English text occurs twice, or a translation has no English text above it
     */
    static Map<String, String> parse(String content) {
        Map<String, String> translations = new HashMap<>();
        String english = null;
        for (String line : content.lines().toList()) {
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            if (!line.startsWith(INDENT)) {
                english = line.replace("\\n", "\n");
            } else if (english == null || translations.put(english, line.substring(INDENT.length()).replace("\\n", "\n")) != null) {
                throw new IllegalArgumentException("no English words of their own above " + Quote.of(line));
            }
        }
        return Map.copyOf(translations);
    }
}
