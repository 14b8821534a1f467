package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.shading.ClearMaterialShader;
import lightning.render.shading.LightWeight;
import lightning.render.shading.WeightedLight;
import lightning.scene.value.Fog;

/**
 * Adds fog to the colors of a tile's camera rays:
 *
 * <pre>
 * C = T·surface + color·[(1 − T)·ambient + Σ weight·scattered]
 * </pre>
 *
 * <p>Holds scratch memory: use one instance per thread.
 */
public final class FogComposer {
    private final float[] sum = new float[Film.TILE_PIXELS];

    /** Returns one channel of a color behind fog. */
    public static float color(float surface, float transmittance, float color, float ambient, float scattered) {
        return surface * transmittance + color * ((1 - transmittance) * ambient + scattered);
    }

    /** Returns channel {@code c} of a color behind fog. */
    public static float color(float surface, float transmittance, Fog fog, int c, float scattered) {
        return color(surface, transmittance, ClearMaterialShader.channel(fog.color(), c), ClearMaterialShader.channel(fog.ambient(), c),
                scattered);
    }

    /** Returns channel {@code c} of what white fog scatters of lights {@code from … to − 1} at a position of a tile. */
    public static float scattered(FogTile tile, int position, WeightedLight[] lights, int from, int to, int c) {
        float sum = 0;
        for (int l = from; l < to; l++) {
            float[] column = tile.scattered()[l];
            sum += column == null || lights[l].isDarkInFog() ? 0 : lights[l].fog().channel(c) * column[position];
        }
        return sum;
    }

    /**
     * Adds fog with all its lights.
     *
     * @param colors red, green and blue of the surfaces, {@code float[1024]} each; overwritten
     */
    public void add(FogTile tile, WeightedLight[] lights, Fog fog, float[][] colors) {
        add(tile, lights, 0, lights.length, fog.color(), fog.ambient(), colors);
    }

    /**
     * Adds fog with some of its lights.
     *
     * @param from    the first light
     * @param to      the light after the last
     * @param color   color of the fog
     * @param ambient light that comes from all sides
     */
    public void add(FogTile tile, WeightedLight[] lights, int from, int to, Rgb color, Rgb ambient, float[][] colors) {
        for (int c = 0; c < 3; c++) {
            Arrays.fill(sum, 0);
            for (int l = from; l < to; l++) {
                float[] scattered = tile.scattered()[l];
                if (scattered != null && !FogLookup.isDark(scattered) && !lights[l].isDarkInFog()) {
                    addWeighted(scattered, lights[l].fog(), c);
                }
            }
            float tint = ClearMaterialShader.channel(color, c);
            float even = ClearMaterialShader.channel(ambient, c);
            float[] column = colors[c];
            float[] transmittance = tile.transmittance();
            for (int i = 0; i < column.length; i++) {
                column[i] = color(column[i], transmittance[i], tint, even, sum[i]);
            }
        }
    }

    /**
     * Adds fog with one light to one color.
     *
     * @param position pixel or sample of the tile
     * @param l        index of the light
     * @param color    receives red, green and blue from {@code at}
     */
    public static void addLight(FogTile tile, int position, WeightedLight[] lights, int l, Fog fog, float[] color, int at) {
        for (int c = 0; c < 3; c++) {
            color[at + c] = color(color[at + c], tile.transmittance()[position], ClearMaterialShader.channel(fog.color(), c), 0,
                    scattered(tile, position, lights, l, l + 1, c));
        }
    }

    private void addWeighted(float[] scattered, LightWeight weight, int c) {
        float factor = weight.channel(c);
        for (int i = 0; i < scattered.length; i++) {
            sum[i] += factor * scattered[i];
        }
    }
}
