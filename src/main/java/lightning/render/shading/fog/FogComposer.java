package lightning.render.shading.fog;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.image.Film;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightWeight;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.FilmMixer;
import lightning.scene.value.Fog;
import org.jspecify.annotations.Nullable;

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
        return color(surface, transmittance, LightWeight.channel(fog.color(), c), LightWeight.channel(fog.ambient(), c),
                scattered);
    }

    /**
     * Adds fog to some films, and before earlier mirrors.
     *
     * @param films  films that are composed; none is dark
     * @param colors of the surfaces; overwritten
     */
    public void add(FogTile tile, FilmParts parts, BitSet films, Fog fog, FilmColors colors) {
        for (int part = films.nextSetBit(0); part >= 0; part = films.nextSetBit(part + 1)) {
            add(tile.transmittance(), tile.scattered(), parts, part, fog, Film.TILE_PIXELS, colors);
        }
        dim(tile, parts.count(), parts.count() + FilmMixer.EARLIER_FILMS, colors);
    }

    /** Dims all films as by fog without light. */
    public void dim(FogTile tile, FilmParts parts, FilmColors colors) {
        dim(tile, 0, parts.count() + FilmMixer.EARLIER_FILMS, colors);
    }

    private static void dim(FogTile tile, int from, int to, FilmColors colors) {
        for (int film = from; film < to; film++) {
            float[][] its = colors.get(film);
            for (int c = 0; its != null && c < 3; c++) {
                for (int i = 0; i < Film.TILE_PIXELS; i++) {
                    its[c][i] *= tile.transmittance()[i];
                }
            }
        }
    }

    /**
     * Adds fog along rays to one film.
     *
     * @param transmittance share of the light behind the fog that passes, by ray
     * @param scattered     light that the fog scatters of each light of weight 1, by ray; null for none, and for lights without
     */
    void add(float[] transmittance, float @Nullable [] @Nullable [] scattered, FilmParts parts, int part, Fog fog, int rays,
            FilmColors colors) {
        FilmPart its = parts.get(part);
        boolean isLit = false;
        for (int l = its.from(); l < its.to(); l++) {
            isLit |= shines(scattered, parts.lights(), l);
        }
        boolean hasAmbient = its.kind() == FilmPart.Kind.REST && !fog.ambient().isBlack();
        if (colors.get(part) == null && !isLit && !hasAmbient) {
            return;
        }
        float[][] to = colors.toWrite(part);
        for (int c = 0; c < 3; c++) {
            Arrays.fill(sum, 0, rays, 0);
            for (int l = its.from(); l < its.to(); l++) {
                if (shines(scattered, parts.lights(), l)) {
                    addWeighted(requireNonNull(requireNonNull(scattered)[l]), parts.lights()[l].fog().channel(c), rays);
                }
            }
            float tint = LightWeight.channel(fog.color(), c);
            float even = hasAmbient ? LightWeight.channel(fog.ambient(), c) : 0;
            float[] column = to[c];
            for (int i = 0; i < rays; i++) {
                column[i] = color(column[i], transmittance[i], tint, even, sum[i]);
            }
        }
    }

    private static boolean shines(float @Nullable [] @Nullable [] scattered, WeightedLight[] lights, int l) {
        return scattered != null && scattered[l] != null && !FogLookup.isDark(requireNonNull(scattered[l])) && !lights[l].isDarkInFog();
    }

    private void addWeighted(float[] scattered, float factor, int rays) {
        for (int i = 0; i < rays; i++) {
            sum[i] += factor * scattered[i];
        }
    }
}
