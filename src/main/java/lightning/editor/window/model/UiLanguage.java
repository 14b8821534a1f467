package lightning.editor.window.model;

import java.util.Locale;
import lightning.base.text.Language;
import lightning.base.text.Messages;

/** Which language the editor is to speak. */
public enum UiLanguage {
    /** The system's, or English where the editor does not speak that. */
    SYSTEM(Messages.key("System")), ENGLISH(Language.ENGLISH.toString()), GERMAN(Language.GERMAN.toString());

    /** A language, {@code english} or {@code german}, that takes the place of what was chosen. */
    public static final String PROPERTY = "lightning.language";

    private final String title;

    UiLanguage(String title) {
        this.title = title;
    }

    /** Speaks as was chosen; before any window is made. */
    public static void activate(Preferences preferences) {
        Messages.setLanguage(of(preferences).resolve(System.getProperty(PROPERTY, ""),
                System.getProperty("user.language.display", System.getProperty("user.language", ""))));
        // The window toolkit's own words, on buttons and in the menus of fields, are in the language of the process.
        Locale.setDefault(Locale.of(Messages.language().letters(), System.getProperty("user.country", "")));
    }

    /** What was chosen. */
    public static UiLanguage of(Preferences preferences) {
        return preferences.enumValue("language", SYSTEM);
    }

    /** Keeps it. */
    public void save(Preferences preferences) {
        preferences.set("language", name());
    }

    /**
     * What is spoken.
     *
     * @param requested  the value of the property; empty for none
     * @param system the system's language in two letters
     */
    Language resolve(String requested, String system) {
        for (Language language : Language.values()) {
            if (language.name().equalsIgnoreCase(requested)) {
                return language;
            }
        }
        return switch (this) {
            case SYSTEM -> Language.forSystem(system);
            case ENGLISH -> Language.ENGLISH;
            case GERMAN -> Language.GERMAN;
        };
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
