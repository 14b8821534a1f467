package lightning.editor.window.model;

import java.util.Locale;
import lightning.base.text.Language;
import lightning.base.text.Texts;

/** Which language the editor is to speak. */
public enum Speech {
    /** The system's, or English where the editor does not speak that. */
    SYSTEM(Texts.key("The System's")), ENGLISH(Language.ENGLISH.toString()), GERMAN(Language.GERMAN.toString());

    /** A language, {@code english} or {@code german}, that takes the place of what was chosen. */
    public static final String PROPERTY = "lightning.language";

    private final String title;

    Speech(String title) {
        this.title = title;
    }

    /** Speaks as was chosen; before any window is made. */
    public static void begin(Preferences preferences) {
        Texts.speak(of(preferences).language(System.getProperty(PROPERTY, ""),
                System.getProperty("user.language.display", System.getProperty("user.language", ""))));
        // The window toolkit's own words, on buttons and in the menus of fields, are in the language of the process.
        Locale.setDefault(Locale.of(Texts.language().letters(), System.getProperty("user.country", "")));
    }

    /** What was chosen. */
    public static Speech of(Preferences preferences) {
        return preferences.choice("language", SYSTEM);
    }

    /** Keeps it. */
    public void remember(Preferences preferences) {
        preferences.set("language", name());
    }

    /**
     * What is spoken.
     *
     * @param asked  the value of the property; empty for none
     * @param system the system's language in two letters
     */
    Language language(String asked, String system) {
        for (Language language : Language.values()) {
            if (language.name().equalsIgnoreCase(asked)) {
                return language;
            }
        }
        return switch (this) {
            case SYSTEM -> Language.ofSystem(system);
            case ENGLISH -> Language.ENGLISH;
            case GERMAN -> Language.GERMAN;
        };
    }

    @Override
    public String toString() {
        return Texts.of(title);
    }
}
