package lightning.base.text;

import java.util.Map;

/** The German bundle, for tests. */
public final class GermanTexts {
    private GermanTexts() {}

    /** German words by the English ones. */
    public static Map<String, String> all() {
        return TextBundle.of(Language.GERMAN);
    }
}
