package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Loads the translations of a language from its gettext catalog next to this class. */
final class MessageBundle {
    private MessageBundle() {
    }

    /** Returns the translations by their English texts; empty for English. */
    static Map<String, String> load(Language language) {
        if (language.bundle().isEmpty()) {
            return Map.of();
        }
        try (InputStream in = MessageBundle.class.getResourceAsStream(language.bundle())) {
            return new PoParser(new String(in.readAllBytes(), StandardCharsets.UTF_8)).parse();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
