package lightning.base.text;

import java.util.Map;

/** The German bundle, for tests. */
public final class GermanMessages {
    private GermanMessages() {}

    /** German words by the English ones. */
    public static Map<String, String> all() {
        return MessageBundle.load(Language.GERMAN);
    }
}
