package lightning.text;

import java.util.Locale;

/** A language that the editor speaks. */
public enum Language {
    /** Its numbers are written as the scene's file and the command line write them. */
    ENGLISH("English", Locale.ROOT, ""),
    GERMAN("Deutsch", Locale.GERMAN, "german.texts");

    private final String name;
    private final Locale locale;
    private final String bundle;

    Language(String name, Locale locale, String bundle) {
        this.name = name;
        this.locale = locale;
        this.bundle = bundle;
    }

    /** The language of a system by its two letters, {@code de}: English where the editor does not speak it. */
    public static Language ofSystem(String letters) {
        return letters.equals(GERMAN.locale.getLanguage()) ? GERMAN : ENGLISH;
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
