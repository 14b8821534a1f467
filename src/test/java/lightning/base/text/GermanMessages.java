package lightning.base.text;

import java.util.Map;

/** German bundle for tests. */
public final class GermanMessages {
    private GermanMessages() {}

    /** Returns the German texts by the English ones. */
    public static Map<String, String> all() {
        return MessageBundle.load(Language.GERMAN);
    }
}
