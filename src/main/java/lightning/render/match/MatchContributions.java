package lightning.render.match;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.PictureFilms;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/** Contributions of all lights that shine in a picture, as means over cells. */
public record MatchContributions(Scene scene, PixelMeans grid, Map<Contribution, float[][]> images) {
    /** Memory for all contributions; with many lights, cells are larger than pixels. */
    private static final long MAX_BYTES = 512L << 20;

    /**
     * Reads the contributions from the cache of a picture. Casts no ray.
     *
     * @param cache    cache of a picture; not modified
     * @param options  options of its render
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static MatchContributions of(PixelCache cache, RenderOptions options, Progress progress) {
        List<Contribution> shining = Contribution.shining(cache.scene());
        PixelMeans grid = grid(cache.film(), shining.size() + 2);
        PictureFilms films = new PictureFilms(cache, options);
        Map<Contribution, float[][]> images = new HashMap<>();
        films.forEachShining(progress, (part, film) -> images.put(part, grid.of(film)));
        return new MatchContributions(cache.scene(), grid, Map.copyOf(images));
    }

    /** Returns cells of so many pixels that all images fit into the memory. */
    private static PixelMeans grid(Film picture, int images) {
        int side = 1;
        while ((long) images * 3 * Float.BYTES * Math.ceilDiv(picture.width(), side) * Math.ceilDiv(picture.height(), side) > MAX_BYTES) {
            side++;
        }
        return new PixelMeans(Math.ceilDiv(picture.width(), side), Math.ceilDiv(picture.height(), side));
    }

    /** Returns a contribution that shines, {@code float[channel][cell]}; not to be modified. */
    float[][] image(Contribution part) {
        return requireNonNull(images.get(part));
    }
}
