package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * The texts of a language, from a file in UTF-8 beside this class: a line with the English words, and below it, after four spaces, those of
 * the language; {@code \n} is a new line. Empty lines and those that begin with {@code #} say nothing.
 */
final class MessageBundle {
    private static final String INDENT = "    ";

    private MessageBundle() {
    }

    /** Words of the language by the English ones. */
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
     * Reads a bundle.
     *
     * @throws IllegalArgumentException if English words come twice, or a line of other words has none above it
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
