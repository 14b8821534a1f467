package lightning.scene.sky;

import io.soabase.recordbuilder.core.RecordBuilder;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.asset.Environment;
import lightning.scene.value.SceneLimits;

/**
 * Physical sky of a clear day.
 *
 * @param on        whether it is the environment of the scene
 * @param elevation of the sun above the horizon, degrees, {@value #MIN_ELEVATION} … 90
 * @param azimuth   of the sun, degrees from −z (north) toward x (east)
 * @param turbidity amount of haze: 1 for pure air, 2 to 3 for a clear day, {@value #MAX_TURBIDITY} for haze
 * @param ground    share of light that the ground reflects, linear color, 0…1
 * @param sun       factor of the sun's light, ≥ 0; 0 for the sky alone
 * @param sunRadius half the angle of the sun's disc, degrees
 * @param unit      unit of its brightness
 */
@RecordBuilder
public record Sky(boolean on, double elevation, double azimuth, double turbidity, Rgb ground, double sun, double sunRadius, SkyUnit unit)
        implements SkyBuilder.With {
    public static final double MIN_ELEVATION = -18;
    public static final double MAX_TURBIDITY = 10;
    public static final double MIN_SUN_RADIUS = 0.05;
    public static final double MAX_SUN_RADIUS = 20;
    public static final Sky NONE = new Sky(false, 35, 135, 2, Rgb.gray(0.3), 1, 0.265, SkyUnit.RELATIVE);

    /** @throws IllegalArgumentException if a value is out of range; the message says which */
    public Sky {
        SceneLimits.checkRange("sky_elevation", elevation, MIN_ELEVATION, 90);
        SceneLimits.checkRange("sky_azimuth", azimuth, -SceneLimits.MAX_ROTATION, SceneLimits.MAX_ROTATION);
        SceneLimits.checkRange("sky_turbidity", turbidity, 1, MAX_TURBIDITY);
        SceneLimits.checkRange("sky_ground", ground, 1);
        SceneLimits.checkRange("sky_sun", sun, 0, SceneLimits.MAX_GROUP_INTENSITY);
        SceneLimits.checkRange("sky_sun_radius", sunRadius, MIN_SUN_RADIUS, MAX_SUN_RADIUS);
    }

    /** Returns the unit direction to the sun. */
    Vec3 direction() {
        double cos = Transform.cosDegrees(elevation);
        return new Vec3(Transform.sinDegrees(azimuth) * cos, Transform.sinDegrees(elevation), -Transform.cosDegrees(azimuth) * cos);
    }

    /** Returns its image with the sun; the same object for the same sky as long as memory is not short. */
    public Environment environment() {
        return SkyImages.of(withOn(true));
    }
}
