package lightning.format.exchange.assembly;

import java.util.Arrays;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.scene.light.LightType;

/**
 * Unit of the light intensities in a glTF file. The format defines candela and lux, but exporters differ and offer a choice.
 *
 * <p>In Lightning, a light of intensity 1 gives a white surface that faces it at distance 1 the brightness 1. A lamp of E
 * watts per square meter gives E / π. Exporters assume 683 lumens per watt for every color.
 */
public enum LightUnits {
    /** The glTF specification: candela for points and spots, lux for directional lights. */
    CANDELA("candela and lux"),
    /** Watts per steradian for points and spots, watts per square meter for directional lights; exporters call this unitless. */
    UNITLESS("watts per steradian and per square meter"),
    /** Total watts for points and spots, watts per square meter for directional lights. */
    WATTS("watts, and watts per square meter");

    private static final double LUMENS_PER_WATT = 683;
    private static final Pattern BLENDER = Pattern.compile("Khronos glTF Blender I/O v(\\d{1,4})\\.(\\d{1,4})\\.(\\d{1,4})");
    /** First version of Blender's exporter that converts its watts, from October 2022. */
    private static final int[] FIRST_STANDARD = {3, 4, 40};

    private final String description;

    LightUnits(String description) {
        this.description = description;
    }

    /**
     * Returns the units that a program's exporter writes by default.
     *
     * @param generator name and version, as in a glTF file's {@code asset.generator}
     */
    public static LightUnits writtenBy(String generator) {
        Matcher blender = BLENDER.matcher(generator);
        if (!blender.lookingAt()) {
            return CANDELA;
        }
        int[] version = IntStream.rangeClosed(1, FIRST_STANDARD.length).map(i -> Integer.parseInt(blender.group(i))).toArray();
        return Arrays.compare(version, FIRST_STANDARD) < 0 ? WATTS : CANDELA;
    }

    /** Returns the intensity in Lightning of a light with intensity 1 in the file. */
    public double intensityOfOneUnit(LightType type) {
        double watts = switch (this) {
            case CANDELA -> 1 / LUMENS_PER_WATT;
            case UNITLESS -> 1;
            case WATTS -> type == LightType.DIRECTIONAL ? 1 : 1 / (4 * Math.PI);
        };
        return watts / Math.PI;
    }

    /** Returns the brightness in Lightning of a surface that glows with 1 in the file: a nit by the specification, else without a unit. */
    public double brightnessOfOneUnit() {
        return this == CANDELA ? 1 / LUMENS_PER_WATT : 1;
    }

    /** Returns the units in words. */
    public String description() {
        return description;
    }

    /** Returns the comment line that records the units in a scene file. */
    String comment() {
        return "# light units: the file's numbers were taken as " + description;
    }

    /** Returns the units recorded in a scene file's text; empty if none were chosen at import. */
    public static Optional<LightUnits> findIn(String text) {
        return Stream.of(values()).filter(units -> text.lines().anyMatch(units.comment()::equals)).findFirst();
    }
}
