package lightning.render.shading;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.render.gather.cell.DirectionCells;
import lightning.render.gather.cell.SkyCells;
import lightning.scene.GatherSettings;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * Light of gathering rays that leave the scene: that of an environment without its small bright parts, which are lights, or that of the
 * background.
 *
 * @param color     linear color of all directions; black with an environment
 * @param map       environment; empty for none, or if it does not light the scene
 * @param rotation  rotation of the environment
 * @param intensity factor of the environment's light
 * @param seen      linear color that blurred reflections see without an environment; black if there are none
 */
public record BackgroundLight(Rgb color, Optional<EnvironmentMap> map, DomeRotation rotation, double intensity, Rgb seen) {
    public static final BackgroundLight NONE = new BackgroundLight(Rgb.BLACK, Optional.empty(), DomeRotation.NONE, 0, Rgb.BLACK);

    /** Returns the light of a scene's background. */
    public static BackgroundLight of(Scene scene) {
        World world = scene.world();
        Optional<Environment> environment = world.environment();
        if (environment.isPresent()) {
            return scene.rig().isEnvironmentActive()
                    ? new BackgroundLight(Rgb.BLACK, environment.map(Environment::map), world.dome(), world.lightIntensity(),
                            Rgb.BLACK)
                    : NONE;
        }
        boolean isLit = scene.picture().indirect().map(IndirectSettings::background).orElse(false);
        boolean isSeen = GatherSettings.of(scene).map(GatherSettings::reflections).orElse(false);
        return new BackgroundLight(isLit ? world.background() : Rgb.BLACK, Optional.empty(), DomeRotation.NONE, 0,
                isSeen ? world.background() : Rgb.BLACK);
    }

    /** Returns this light as edge detection sees it, as {@link WeightedLight#forEdges}. */
    public BackgroundLight forEdges() {
        return map.isEmpty() ? this
                : new BackgroundLight(color, map, rotation, LightWeight.nearestPowerOfTwo((float) intensity), seen);
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

    /**
     * Writes the light of the cells of the sky that reflections see: red, green and blue of each.
     *
     * @param at     first element
     * @param stride elements of each cell
     */
    void writeSky(float[] to, int at, int stride) {
        double[] direction = new double[3];
        double[] radiance = new double[3];
        for (int cell = 0; cell < SkyCells.COUNT; cell++) {
            int first = at + stride * cell;
            if (map.isPresent()) {
                SkyCells.writeCenter(cell, direction);
                map.get().smoothRadiance(direction[0], direction[1], direction[2], rotation, radiance);
                for (int c = 0; c < 3; c++) {
                    to[first + c] = limited(radiance[c]);
                }
            } else {
                to[first] = (float) seen.r();
                to[first + 1] = (float) seen.g();
                to[first + 2] = (float) seen.b();
            }
        }
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
