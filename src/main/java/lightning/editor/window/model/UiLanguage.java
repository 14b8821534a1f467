package lightning.editor.window.model;

import java.util.Locale;
import lightning.base.text.Language;
import lightning.base.text.Messages;

/** Interface language setting. */
public enum UiLanguage {
    /** The system's language, or English if it is not supported. */
    SYSTEM(Messages.key("System")), ENGLISH(Language.ENGLISH.toString()), GERMAN(Language.GERMAN.toString());

    /** System property that overrides the setting: {@code english} or {@code german}. */
    public static final String PROPERTY = "lightning.language";

    private final String title;

    UiLanguage(String title) {
        this.title = title;
    }

    /** Activates the stored language. Call before creating any window. */
    public static void activate(Preferences preferences) {
        Messages.setLanguage(of(preferences).resolve(System.getProperty(PROPERTY, ""),
                System.getProperty("user.language.display", System.getProperty("user.language", ""))));
        // JavaFX's own texts, on buttons and in field menus, use the default locale.
        Locale.setDefault(Locale.of(Messages.language().letters(), System.getProperty("user.country", "")));
    }

    /** Returns the stored setting. */
    public static UiLanguage of(Preferences preferences) {
        return preferences.enumValue("language", SYSTEM);
    }

    /** Stores the setting. */
    public void save(Preferences preferences) {
        preferences.set("language", name());
    }

    /**
     * Returns the language to use.
     *
     * @param requested  value of {@link #PROPERTY}; empty for none
     * @param system  two-letter code of the system's language
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
