package lightning.render.shading;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.render.gather.DirectionCells;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;

/**
 * Light of gathering rays that leave the scene: that of an environment without its small bright parts, which are lights, or that of the
 * background.
 *
 * @param color     linear color of all directions; black with an environment
 * @param map       environment; empty for none, or if it does not light the scene
 * @param rotation  of the environment about y, degrees
 * @param intensity factor of the environment's light
 */
public record BackgroundLight(Rgb color, Optional<EnvironmentMap> map, double rotation, double intensity) {
    public static final BackgroundLight NONE = new BackgroundLight(Rgb.BLACK, Optional.empty(), 0, 0);

    /** Returns the light of a scene's background. */
    public static BackgroundLight of(Scene scene) {
        World world = scene.world();
        if (world.environment().isPresent()) {
            return scene.rig().isEnvironmentActive()
                    ? new BackgroundLight(Rgb.BLACK, Optional.of(world.environment().get().map()), world.rotation(), world.lightIntensity())
                    : NONE;
        }
        boolean isLit = scene.picture().indirect().map(IndirectSettings::background).orElse(false);
        return isLit ? new BackgroundLight(world.background(), Optional.empty(), 0, 0) : NONE;
    }

    /** Returns this light as edge detection sees it, as {@link WeightedLight#forEdges}. */
    public BackgroundLight forEdges() {
        return map.isEmpty() ? this
                : new BackgroundLight(color, map, rotation, LightWeight.nearestPowerOfTwo((float) intensity));
    }

    /** Returns the light from a direction, red, green and blue, where it is not divided into cells. */
    public float[] from(double x, double y, double z) {
        if (map.isEmpty()) {
            return new float[] {(float) color.r(), (float) color.g(), (float) color.b()};
        }
        double[] radiance = new double[3];
        map.get().smoothRadiance(x, y, z, rotation, radiance);
        return new float[] {limited(radiance[0]), limited(radiance[1]), limited(radiance[2])};
    }

    private float limited(double radiance) {
        return (float) Math.min(radiance * intensity, SceneLimits.MAX_EMISSION);
    }

    /**
     * Returns the light of all rays that leave the scene, red, green and blue of each number.
     *
     * @param misses 1, or {@link DirectionCells#COUNT}
     */
    public float[] cells(int misses) {
        float[] light = new float[3 * misses];
        double[] mean = map.isPresent() && misses > 1 ? EnvironmentCells.means(map.get().smoothGrid(), rotation) : null;
        for (int i = 0; i < light.length; i++) {
            light[i] = mean != null ? limited(mean[i]) : (float) (i % 3 == 0 ? color.r() : i % 3 == 1 ? color.g() : color.b());
        }
        return light;
    }
}
