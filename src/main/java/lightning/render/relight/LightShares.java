package lightning.render.relight;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightWeight;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;

/**
 * Shares of the contributions in a picture: the luminance of a contribution divided by that of the picture, both summed over all pixels, with
 * reflections and indirect light. The share of an environment includes its visible background. This is the only measure of shares: the light
 * mixer and the report of light contributions show it.
 *
 * @param totals sum of the pixels of each film, without its weight: red, green and blue
 * @param other  luminance of what belongs to no film: mirrors that show an earlier scene
 */
public record LightShares(FilmParts parts, double[][] totals, double other) {
    /**
     * Computes the shares in a picture. Casts no ray.
     *
     * @param cache    cache of a picture; not modified
     * @param options  options of its render
     * @param progress counts tiles
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static LightShares of(PixelCache cache, RenderOptions options, Progress progress) {
        return of(new PictureFilms(cache, options), cache.film(), LightContributions.Region.ofFilm(cache.film()), progress);
    }

    /** Computes the shares in a region of a picture, as above. */
    static LightShares of(PictureFilms films, Film picture, LightContributions.Region region, Progress progress) {
        double[][] totals = films.totals(region, progress);
        LightShares shares = new LightShares(films.parts(), totals, 0);
        double other = region.luminance(picture) - shares.luminance(films.parts().shining());
        return new LightShares(films.parts(), totals, films.showsEarlierMirrors() ? Math.max(0, other) : 0);
    }

    /**
     * Returns the shares in an edited scene, without a picture of it.
     *
     * @return empty if more than the weights of contributions differ, or if one was dark and shines
     */
    public Optional<LightShares> in(Scene edited) {
        if (!unweighted(edited).equals(unweighted(parts.scene()))) {
            return Optional.empty();
        }
        FilmParts after = FilmParts.of(edited);
        BitSet known = parts.shining();
        BitSet shining = after.shining();
        shining.andNot(known);
        return after.count() == parts.count() && shining.isEmpty() ? Optional.of(new LightShares(after, totals, other)) : Optional.empty();
    }

    /** Returns a scene in which the contributions of lights and environments have no weights. */
    private static Scene unweighted(Scene scene) {
        List<Light> lights = scene.lights().stream().map(light -> scene.rig().effectiveLight(light).withLightGroup("").withColor(Rgb.WHITE)
                .withIntensity(1).withOn(true).withSolo(false)).toList();
        World world = scene.world();
        return scene.withRig(LightRig.of(lights)).withWorld(world.withAmbience(1)
                .withDomes(world.domes().stream().map(dome -> dome.withIntensity(1).withOn(true).withSolo(false)).toList()));
    }

    /** Returns the scene of the picture. */
    public Scene scene() {
        return parts.scene();
    }

    /** Returns the share of a contribution; 0 in a black picture, and for one that the scene does not have. */
    public double of(Contribution contribution) {
        double whole = luminance(parts.shining()) + other;
        return whole > 0 ? luminance(parts.of(contribution)) / whole : 0;
    }

    /** Returns 0.2126 R + 0.7152 G + 0.0722 B of some films with their weights (ITU-R BT.709). */
    private double luminance(BitSet films) {
        return films.stream().mapToDouble(film -> {
            LightWeight weight = parts.get(film).weight();
            double[] total = totals[film];
            return 0.2126 * weight.red() * total[0] + 0.7152 * weight.green() * total[1] + 0.0722 * weight.blue() * total[2];
        }).sum();
    }
}
