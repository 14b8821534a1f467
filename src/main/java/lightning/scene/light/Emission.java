package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.attribute.NumericKind;
import lightning.scene.value.ColorTemperature;
import lightning.scene.value.SceneLimits;

/**
 * Factors of a light's color and intensity: exposure, unit and color temperature. {@link LightAttribute} has their ranges.
 *
 * @param exposure    stops: each doubles the light
 * @param unit        unit of the intensity
 * @param temperature kelvin; {@link ColorTemperature#NEUTRAL} keeps the color
 */
@RecordBuilder
public record Emission(double exposure, IntensityUnit unit, double temperature) implements EmissionBuilder.With {
    /** Largest absolute exposure, stops. */
    public static final double MAX_EXPOSURE = 64;
    static final NumericKind<Double> EXPOSURES = NumericKind.stops(-MAX_EXPOSURE, MAX_EXPOSURE, 0.1);
    static final NumericKind<Double> TEMPERATURES = NumericKind.kelvin(ColorTemperature.MIN, ColorTemperature.MAX, 100);

    /** Initial values of a light: color and intensity as they are. */
    public static final Emission DEFAULT = new Emission(0, IntensityUnit.RELATIVE, ColorTemperature.NEUTRAL);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Emission {
        EXPOSURES.check("exposure", exposure);
        TEMPERATURES.check("temperature", temperature);
    }

    /** Returns a color with the temperature's hue and its own brightness. */
    public Rgb tinted(Rgb color) {
        Rgb tint = ColorTemperature.tint(temperature);
        return color.times(tint.times(1 / tint.max()));
    }

    /**
     * Returns a light that shines as the given one, with exposure, unit and temperature multiplied into its color and intensity, and the
     * mean color of its texture if it has hard shadows. The
     * intensity is limited so that no contribution overflows; see {@link SceneLimits}.
     *
     * @param meters meters per scene unit
     */
    static Light resolve(Light light, double meters) {
        if (light.area().hardShadows() && light.texture().isPresent()) {
            return resolve(light.withMeanTexture().withTexture(Optional.empty()), meters);
        }
        if (light.emission().equals(DEFAULT)) {
            double intensity = limited(light, light.intensity());
            return intensity == light.intensity() ? light : light.withIntensity(intensity);
        }
        double intensity = light.intensity() * StrictMath.pow(2, light.emission().exposure())
                * light.emission().unit().relative(light, meters) * ColorTemperature.tint(light.emission().temperature()).max();
        return light.withColor(light.emission().tinted(light.color())).withIntensity(limited(light, intensity)).withEmission(DEFAULT);
    }

    /**
     * Returns a light that shines the same with its intensity in another unit; the same intensity if it has none in the units, as the
     * luminance of a light without size.
     *
     * @param meters meters per scene unit
     */
    public static Light withUnit(Light light, IntensityUnit unit, double meters) {
        double factor = light.emission().unit().relative(light, meters) / unit.relative(light, meters);
        double intensity = factor > 0 && factor < Double.POSITIVE_INFINITY ? light.intensity() * factor : light.intensity();
        return light.emission().unit() == unit ? light
                : light.withEmission(light.emission().withUnit(unit)).withIntensity(Math.min(intensity, SceneLimits.MAX_INTENSITY));
    }

    /** Limits an intensity so that times the largest falloff it is one that a light may have; not a number becomes 0. */
    private static double limited(Light light, double intensity) {
        return intensity >= 0 ? Math.min(intensity, light.maxIntensity()) : 0;
    }
}
