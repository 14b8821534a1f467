package lightning.format.exchange;

import java.util.Optional;
import java.util.stream.Stream;
import lightning.scene.LightType;

/**
 * What the numbers of a file's lights mean. The format says candela and lux; exporters differ, and may ask which to write.
 *
 * <p>A light of intensity 1 here makes a white surface that faces it at distance 1 as bright as 1. A lamp of E watts per square
 * meter makes it E / π. A watt of light is 683 lumen where the eye is best, which is what exporters reckon with whatever the color.
 */
public enum LightUnits {
    /** As glTF says: candela of points and spots, lux of directional lights. */
    CANDELA("candela and lux"),
    /** Watts per steradian of points and spots, watts per square meter of directional lights; exporters say unitless. */
    UNITLESS("watts per steradian and per square meter"),
    /** Watts in all directions together of points and spots, watts per square meter of directional lights. */
    WATTS("watts, and watts per square meter");

    private static final double LUMENS_PER_WATT = 683;

    private final String description;

    LightUnits(String description) {
        this.description = description;
    }

    /** How a light of 1 in the file shines here. */
    public double intensityOfOneUnit(LightType type) {
        double watts = switch (this) {
            case CANDELA -> 1 / LUMENS_PER_WATT;
            case UNITLESS -> 1;
            case WATTS -> type == LightType.DIRECTIONAL ? 1 : 1 / (4 * Math.PI);
        };
        return watts / Math.PI;
    }

    /** What the numbers are, in words. */
    public String description() {
        return description;
    }

    /** The line of a scene's file that keeps what was chosen. */
    String comment() {
        return "# light units: the file's numbers were taken as " + description;
    }

    /** What was chosen when the scene of this text was imported; empty where it was not, or nothing was to be chosen. */
    public static Optional<LightUnits> findIn(String text) {
        return Stream.of(values()).filter(units -> text.lines().anyMatch(units.comment()::equals)).findFirst();
    }
}
