package lightning.render.shading;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.render.gather.cell.DirectionCells;
import lightning.render.gather.cell.SkyCells;
import lightning.render.gather.ray.FilmLight;
import lightning.scene.Dome;
import lightning.scene.GatherSettings;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;

/**
 * Light of gathering rays that leave the scene: the sum of all environments without their small bright parts, which are lights, or that of
 * the background.
 *
 * @param color  linear color of all directions; black with an environment
 * @param layers environments that light the scene; empty if none does
 * @param seen   linear color that blurred reflections see without an environment; black if there are none
 */
public record BackgroundLight(Rgb color, List<Layer> layers, Rgb seen) {
    public static final BackgroundLight NONE = new BackgroundLight(Rgb.BLACK, List.of(), Rgb.BLACK);

    /**
     * One environment.
     *
     * @param rotation  rotation of the image
     * @param intensity factor of its light
     */
    public record Layer(EnvironmentMap map, DomeRotation rotation, double intensity) {}

    /** Returns the light of a scene's background. */
    public static BackgroundLight of(Scene scene) {
        World world = scene.world();
        List<Dome> environments = world.environments();
        if (environments.stream().anyMatch(Dome::on)) {
            List<Layer> layers = new ArrayList<>();
            for (int i = 0; i < environments.size(); i++) {
                Dome environment = environments.get(i);
                if (scene.rig().isEnvironmentActive(i)) {
                    layers.add(new Layer(environment.map(), environment.rotation(), environment.lightIntensity()));
                }
            }
            return new BackgroundLight(Rgb.BLACK, List.copyOf(layers), Rgb.BLACK);
        }
        boolean isLit = scene.picture().indirect().map(IndirectSettings::background).orElse(false);
        boolean isSeen = GatherSettings.of(scene).map(GatherSettings::reflections).orElse(false);
        return new BackgroundLight(isLit ? world.background() : Rgb.BLACK, List.of(), isSeen ? world.background() : Rgb.BLACK);
    }

    /** Returns the light of a scene's background color; {@link #NONE} with an environment. */
    static BackgroundLight ofColor(Scene scene) {
        return scene.world().environments().stream().anyMatch(Dome::on) ? NONE : of(scene);
    }

    /** Returns the light of an environment. @param intensity factor of its light */
    static BackgroundLight of(Dome environment, double intensity) {
        return new BackgroundLight(Rgb.BLACK, List.of(new Layer(environment.map(), environment.rotation(), intensity)), Rgb.BLACK);
    }

    /** Returns the light from a direction, red, green and blue, where it is not divided into cells. */
    public float[] from(double x, double y, double z) {
        if (layers.isEmpty()) {
            return new float[] {(float) color.r(), (float) color.g(), (float) color.b()};
        }
        float[] light = new float[3];
        writeSum(x, y, z, new double[3], new double[3], light, 0);
        return light;
    }

    /**
     * Writes the light of the cells of the sky that reflections see: of the finest ones at their centers, of others the mean of their parts.
     *
     * @param first number of the first cell
     */
    void writeSky(FilmLight to, int first, int film) {
        if (layers.isEmpty()) {
            for (int cell = 0; cell < SkyCells.NUMBERS; cell++) {
                to.set(first + cell, film, (float) seen.r(), (float) seen.g(), (float) seen.b());
            }
            return;
        }
        double[] direction = new double[3];
        double[] radiance = new double[3];
        double[] sum = new double[3];
        for (int cell = 0; cell < SkyCells.FINEST_COUNT; cell++) {
            SkyCells.writeCenter(cell, direction);
            writeSum(direction[0], direction[1], direction[2], radiance, sum, to.values(), to.at(first + cell, film));
        }
        for (int cell = SkyCells.FINEST_COUNT; cell < SkyCells.COUNT; cell++) {
            int at = to.at(first + cell, film);
            for (int number = 0; number < 4; number++) {
                int part = to.at(first + SkyCells.part(cell, number), film);
                for (int c = 0; c < 3; c++) {
                    to.values()[at + c] += 0.25f * to.values()[part + c];
                }
            }
        }
    }

    /** Writes the sum of all environments in a direction, with two arrays as scratch memory. */
    private void writeSum(double x, double y, double z, double[] radiance, double[] sum, float[] to, int first) {
        for (int i = 0; i < layers.size(); i++) {
            Layer layer = layers.get(i);
            layer.map.smoothRadiance(x, y, z, layer.rotation, radiance);
            add(sum, i == 0, radiance, layer.intensity);
        }
        for (int c = 0; c < 3; c++) {
            to[first + c] = limited(sum[c]);
        }
    }

    /** Adds a radiance times a factor to a sum, which the first one replaces: the sum of one keeps its bits. */
    private static void add(double[] sum, boolean isFirst, double[] radiance, double factor) {
        for (int i = 0; i < sum.length; i++) {
            double light = radiance[i] * factor;
            sum[i] = isFirst ? light : sum[i] + light;
        }
    }

    private static float limited(double radiance) {
        return (float) Math.min(radiance, SceneLimits.MAX_EMISSION);
    }

    /**
     * Returns the light of all rays that leave the scene, red, green and blue of each number.
     *
     * @param misses 1, or {@link DirectionCells#COUNT}
     */
    public float[] cells(int misses) {
        float[] light = new float[3 * misses];
        if (layers.isEmpty() || misses == 1) {
            for (int i = 0; i < light.length; i++) {
                light[i] = (float) (i % 3 == 0 ? color.r() : i % 3 == 1 ? color.g() : color.b());
            }
            return light;
        }
        double[] sum = new double[light.length];
        for (int i = 0; i < layers.size(); i++) {
            Layer layer = layers.get(i);
            add(sum, i == 0, EnvironmentCells.means(layer.map.smoothGrid(), layer.rotation), layer.intensity);
        }
        for (int i = 0; i < light.length; i++) {
            light[i] = limited(sum[i]);
        }
        return light;
    }
}
