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
final class TextBundle {
    private static final String INDENT = "    ";

    private TextBundle() {
    }

    /** Words of the language by the English ones. */
    static Map<String, String> of(Language language) {
        if (language.bundle().isEmpty()) {
            return Map.of();
        }
        try (InputStream in = TextBundle.class.getResourceAsStream(language.bundle())) {
            return read(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Reads a bundle.
     *
     * @throws IllegalArgumentException if English words come twice, or a line of other words has none above it
     */
    static Map<String, String> read(String file) {
        Map<String, String> words = new HashMap<>();
        String english = null;
        for (String line : file.lines().toList()) {
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            if (!line.startsWith(INDENT)) {
                english = line.replace("\\n", "\n");
            } else if (english == null || words.put(english, line.substring(INDENT.length()).replace("\\n", "\n")) != null) {
                throw new IllegalArgumentException("no English words of their own above " + Quote.of(line));
            }
        }
        return Map.copyOf(words);
    }
}
