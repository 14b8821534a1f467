package lightning.edit;

import java.util.Locale;
import java.util.Optional;
import lightning.scene.LightType;

/** What a light's type may take out of action (paper §3.1). The value is kept all the same. */
public enum Attribute {
    COLOR("color"),
    INTENSITY("intensity"),
    POSITION("position"),
    DIRECTION("direction"),
    ATTENUATION("attenuation"),
    ANGLE("angle"),
    DROPOFF("dropoff");

    private final String title;

    Attribute(String title) {
        this.title = title;
    }

    /** For people, as the scene file calls it but for the position. */
    public String title() {
        return title;
    }

    /** Whether it acts on the picture of a light of this type. */
    public boolean acts(LightType type) {
        return switch (this) {
            case COLOR, INTENSITY -> true;
            case POSITION, ATTENUATION -> type.hasPosition();
            case DIRECTION -> type.hasDirection();
            case ANGLE, DROPOFF -> type.hasCone();
        };
    }

    /** Why its widget is disabled: a clause; empty where it acts. */
    public Optional<String> obstacle(LightType type) {
        return acts(type) ? Optional.empty()
                : Optional.of("a " + type.name().toLowerCase(Locale.ROOT) + " light has no " + title);
    }
}
