package lightning.base.text;

import java.util.Locale;

/** Language of the editor. */
public enum Language {
    /** English, with numbers formatted as in scene files and on the command line. */
    ENGLISH("English", "en", Locale.ROOT, ""),
    GERMAN("Deutsch", "de", Locale.GERMAN, "de.po");

    private final String name;
    private final String code;
    private final Locale locale;
    private final String bundle;

    Language(String name, String code, Locale locale, String bundle) {
        this.name = name;
        this.code = code;
        this.locale = locale;
        this.bundle = bundle;
    }

    /** Returns the language of a system by its two-letter code, such as {@code de}; English if it is not supported. */
    public static Language forSystem(String code) {
        return code.equals(GERMAN.code) ? GERMAN : ENGLISH;
    }

    /** Returns the two-letter code, such as {@code de}. */
    public String letters() {
        return code;
    }

    /** Returns the locale of numbers and times on the screen. */
    public Locale locale() {
        return locale;
    }

    /** Returns the name of the bundle file next to this class; empty for the language of the code. */
    String bundle() {
        return bundle;
    }

    /** Returns the language's own name. */
    @Override
    public String toString() {
        return name;
    }
}
