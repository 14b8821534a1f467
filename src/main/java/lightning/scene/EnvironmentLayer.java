package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.light.AreaShape;
import lightning.scene.light.EnvironmentLights;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * One of the environments whose radiances are summed: that of the world, or a dome.
 *
 * @param name       name of its lights, before a number
 * @param map        its image
 * @param rotation   rotation of the image
 * @param intensity  factor of its image and light
 * @param gain       factor of its light alone
 * @param lightCount maximum number of directional lights of its small bright parts
 * @param softness   spread of each of these over its part, 0 … 1
 * @param on         false if it is neither visible nor lights anything
 * @param solo       true if its light is soloed
 */
public record EnvironmentLayer(String name, EnvironmentMap map, DomeRotation rotation, double intensity, double gain, int lightCount,
        double softness, boolean on, boolean solo) {

    /** Samples of a light that is hardly larger than the sun, and of a larger one. */
    private static final int SUN_SAMPLES = SceneLimits.MIN_LIGHT_SAMPLES;
    private static final int SAMPLES = AreaShape.DEFAULT.samples();
    /** Half-angle of a light with few samples, degrees. */
    private static final double SUN = 1;

    /** Returns this environment with another factor of its light. */
    public EnvironmentLayer withGain(double v) {
        return new EnvironmentLayer(name, map, rotation, intensity, v, lightCount, softness, on, solo);
    }

    /** Returns the factor of its light, ≥ 0; 0 if it is off. */
    public double lightIntensity() {
        return on ? intensity * gain : 0;
    }

    /**
     * Returns the directional lights of its small bright parts. At least one stands for it, even if it is dark.
     *
     * @param isUsed test for names of other lights
     */
    EnvironmentLights brightLights(Predicate<String> isUsed) {
        return new EnvironmentLights(lights(map.brightLights(lightCount), lightCount, isUsed), intensity * gain);
    }

    /**
     * Returns directional lights that stand for all of its light, where nothing gathers its smooth light.
     *
     * @param count  maximum number
     * @param isUsed test for names of other lights
     */
    public List<Light> approximateLights(int count, Predicate<String> isUsed) {
        return new EnvironmentLights(lights(map.lights(count), count, isUsed), intensity * gain).lights();
    }

    private List<Light> lights(List<EnvironmentLight> sources, int count, Predicate<String> isUsed) {
        List<Light> lights = new ArrayList<>();
        String prefix = name;
        while (isAnyUsed(prefix, count, isUsed)) {
            prefix += "'";
        }
        for (EnvironmentLight source : sources) {
            Vec3 direction = rotation.toWorld().transformVector(source.direction());
            double spread = spread(source, direction);
            double maxChannel = Math.max(source.red(), Math.max(source.green(), source.blue()));
            lights.add(Light.of(prefix + " " + (lights.size() + 1), LightType.DIRECTIONAL)
                    .withDirection(direction.negated())
                    .withColor(maxChannel > 0 ? new Rgb(source.red() / maxChannel, source.green() / maxChannel, source.blue() / maxChannel)
                            : Rgb.BLACK)
                    .withOn(on)
                    .withSolo(solo && lightIntensity() > 0)
                    .withIntensity(Math.min(maxChannel * source.meanLength(), SceneLimits.MAX_ENVIRONMENT_LIGHT_INTENSITY))
                    .withArea(AreaShape.DEFAULT.withSpread(spread).withSamples(spread > SUN ? SAMPLES : SUN_SAMPLES)));
        }
        return lights;
    }

    /** Returns the half-angle of a light in degrees, at most its angle to the horizon: light from below would be lost to a floor. */
    private double spread(EnvironmentLight source, Vec3 direction) {
        double elevation = Math.toDegrees(StrictMath.asin(Math.min(Math.abs(direction.y()), 1)));
        return Math.min(source.spread() * softness, elevation);
    }

    private static boolean isAnyUsed(String name, int count, Predicate<String> isUsed) {
        return IntStream.rangeClosed(1, count).anyMatch(number -> isUsed.test(name + " " + number));
    }
}
