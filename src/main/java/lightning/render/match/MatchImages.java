package lightning.render.match;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Predicate;
import lightning.base.work.Progress;
import lightning.render.cache.FineTile;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.LightFilms;
import lightning.render.relight.tile.RenderOptions;

/**
 * Contributions of the lights that a match may change, and all other light, as means over cells.
 *
 * @param grid    cells
 * @param names   lights that contribute anything, {@code environment} for the environment
 * @param lights  {@code float[channel][cell]} of each
 * @param rest    the picture without them, {@code float[channel][cell]}
 * @param unseen  lights that contribute nothing to the picture
 * @param skipped cells that do not count: pixels with finer samples, whose composition would take most of the time
 */
record MatchImages(PixelMeans grid, List<String> names, List<float[][]> lights, float[][] rest, List<String> unseen, BitSet skipped) {
    // Arrays in a record: written once by their creator, never after.
    /** Memory for all contributions; with many lights, cells are larger than pixels. */
    private static final long MAX_BYTES = 512L << 20;

    /**
     * Composes the contributions from the cache of a picture. Casts no ray, except for finer samples where the environment has an edge.
     *
     * @param chosen   names of lights; empty for all that shine
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    static MatchImages of(PixelCache cache, RenderOptions options, Optional<Set<String>> chosen, Progress progress) {
        Film whole = cache.film();
        Predicate<String> isChosen = name -> chosen.isEmpty() || chosen.get().contains(name);
        PixelMeans grid = grid(whole, (int) LightFilms.names(cache.scene()).stream().filter(isChosen).count() + 2);
        BitSet skipped = new BitSet();
        PixelCache composed = cache;
        if (grid.columns() == whole.width() && cache.tileCount() > 0) {
            skipped = finerPixels(cache);
            if (2L * skipped.cardinality() > (long) whole.width() * whole.height()) {
                skipped.clear();
            } else {
                composed = new PixelCache(cache.geometry(), cache.tiles(), new FineTile[0], cache.shown(), cache.mirrored());
            }
        }
        float[][] rest = grid.of(composed.film());
        List<String> names = new ArrayList<>();
        List<float[][]> lights = new ArrayList<>();
        List<String> unseen = new ArrayList<>();
        LightFilms.forEach(composed, options, isChosen, progress, (name, film) -> add(name, grid.of(film), rest, names, lights, unseen));
        return new MatchImages(grid, List.copyOf(names), List.copyOf(lights), rest, List.copyOf(unseen), skipped);
    }

    /** Returns the pixels with finer samples, row by row. */
    private static BitSet finerPixels(PixelCache cache) {
        Film film = cache.film();
        BitSet finer = new BitSet();
        for (int tile = 0; tile < cache.fineCount(); tile++) {
            int left = tile % film.tilesX() * Film.TILE_SIZE;
            int top = tile / film.tilesX() * Film.TILE_SIZE;
            cache.fineTile(tile).first().pixelSet().stream().forEach(pixel -> {
                int x = left + pixel % Film.TILE_SIZE;
                int y = top + pixel / Film.TILE_SIZE;
                if (x < film.width() && y < film.height()) {
                    finer.set(y * film.width() + x);
                }
            });
        }
        return finer;
    }

    /** Returns cells of so many pixels that all images fit into the memory. */
    private static PixelMeans grid(Film picture, int images) {
        int side = 1;
        while ((long) images * 3 * Float.BYTES * Math.ceilDiv(picture.width(), side) * Math.ceilDiv(picture.height(), side) > MAX_BYTES) {
            side++;
        }
        return new PixelMeans(Math.ceilDiv(picture.width(), side), Math.ceilDiv(picture.height(), side));
    }

    private static void add(String name, float[][] image, float[][] rest, List<String> names, List<float[][]> lights, List<String> unseen) {
        boolean isSeen = false;
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < rest[c].length; i++) {
                rest[c][i] -= image[c][i];
                isSeen |= image[c][i] > 0;
            }
        }
        if (isSeen) {
            names.add(name);
            lights.add(image);
        } else {
            unseen.add(name);
        }
    }
}
