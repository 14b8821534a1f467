package lightning.base.text;

import java.util.Locale;

/** A language that the editor speaks. */
public enum Language {
    /** Its numbers are written as the scene's file and the command line write them. */
    ENGLISH("English", "en", Locale.ROOT, ""),
    GERMAN("Deutsch", "de", Locale.GERMAN, "german.texts");

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

    /** The language of a system by its two letters, {@code de}: English where the editor does not speak it. */
    public static Language forSystem(String code) {
        return code.equals(GERMAN.code) ? GERMAN : ENGLISH;
    }

    /** Its two letters, {@code de}. */
    public String letters() {
        return code;
    }

    /** How numbers and times are written on the screen. */
    public Locale locale() {
        return locale;
    }

    /** The file beside this class that has the texts; empty where they are those of the code. */
    String bundle() {
        return bundle;
    }

    /** As those call it who speak it. */
    @Override
    public String toString() {
        return name;
    }
}
