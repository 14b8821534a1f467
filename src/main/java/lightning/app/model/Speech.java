package lightning.app.model;

import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.text.Language;
import lightning.text.Texts;

/** Which language the editor speaks. Belongs to the window's thread. */
public enum Speech {
    /** The system's, or English where the editor does not speak that. */
    SYSTEM(Texts.key("The System's")), ENGLISH(Language.ENGLISH.toString()), GERMAN(Language.GERMAN.toString());

    /** A language, {@code english} or {@code german}, that takes the place of what was chosen. */
    public static final String PROPERTY = "lightning.language";
    private static final ObjectProperty<Speech> CHOSEN = new SimpleObjectProperty<>(SYSTEM);

    private final String title;

    Speech(String title) {
        this.title = title;
    }

    /** What is spoken from the next start on; titles and labels that stand on the screen stay as they are. */
    public static ObjectProperty<Speech> chosenProperty() {
        return CHOSEN;
    }

    /** Speaks as was chosen; before any window is made. */
    public static void begin(Preferences preferences) {
        CHOSEN.set(preferences.choice("language", SYSTEM));
        Texts.speak(CHOSEN.get().language(System.getProperty(PROPERTY, ""),
                System.getProperty("user.language.display", System.getProperty("user.language", ""))));
    }

    /** Keeps what was chosen. */
    public static void remember(Preferences preferences) {
        preferences.set("language", CHOSEN.get().name());
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
