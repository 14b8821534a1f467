package lightning.render.match;

import static java.util.Objects.requireNonNull;

import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.math.Rgb;
import lightning.base.work.Progress;
import lightning.render.cache.FineTile;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.LightFilms;
import lightning.render.relight.LightValues;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;

/**
 * Contributions of all lights that shine in a picture, as means over cells. Composing them takes most of the time of a match, so they serve
 * several matches: an edit of a light's values only scales its own, and an edit of its place leaves all others.
 */
public final class MatchContributions {
    /** Memory for all contributions; with many lights, cells are larger than pixels. */
    private static final long MAX_BYTES = 512L << 20;

    /** Largest share of the light of a contribution that may be in pixels that do not count: the others must show how bright it is. */
    private static final double MAX_HIDDEN = 0.95;
    private static final double[] UNKNOWN = {Double.NaN, Double.NaN, Double.NaN};

    private final Scene scene;
    private final PixelMeans grid;
    private final Map<Contribution, float[][]> images;
    /** True if they are of pixel centers alone. */
    private final boolean omitsFinerSamples;

    private MatchContributions(Scene scene, PixelMeans grid, Map<Contribution, float[][]> images, boolean omitsFinerSamples) {
        this.scene = scene;
        this.grid = grid;
        this.images = images;
        this.omitsFinerSamples = omitsFinerSamples;
    }

    /**
     * Composes the contributions from the cache of a picture. Casts no ray.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param earlier  contributions to an earlier picture; lights whose values alone were edited since then are not composed again
     * @param progress counts lights
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static MatchContributions of(PixelCache cache, RenderOptions options, Optional<MatchContributions> earlier, Progress progress) {
        Scene scene = cache.scene();
        Film whole = cache.film();
        PixelMeans grid = grid(whole, Contribution.shining(scene).size() + 2);
        BitSet finer = finerPixels(cache);
        if (grid.columns() == whole.width() && cache.tileCount() > 0 && 2L * finer.cardinality() <= (long) whole.width() * whole.height()) {
            MatchContributions centers = compose(cache, grid, true, options, earlier, progress);
            if (centers.images.values().stream().noneMatch(image -> isHidden(image, finer))) {
                return centers;
            }
        }
        return compose(cache, grid, false, options, earlier, progress);
    }

    private static MatchContributions compose(PixelCache cache, PixelMeans grid, boolean omitsFinerSamples, RenderOptions options,
            Optional<MatchContributions> earlier, Progress progress) {
        Scene scene = cache.scene();
        Map<Contribution, float[][]> images = earlier.filter(e -> e.grid.equals(grid) && e.omitsFinerSamples == omitsFinerSamples)
                .map(e -> e.scaledTo(scene)).orElseGet(HashMap::new);
        LightFilms.forEach(omitsFinerSamples ? withoutFinerSamples(cache) : cache, options, part -> !images.containsKey(part), progress,
                (part, film) -> images.put(part, grid.of(film)));
        return new MatchContributions(scene, grid, Map.copyOf(images), omitsFinerSamples);
    }

    /** Returns whether much of a contribution is in cells that would not count, such as that of a light that shines on thin things alone. */
    private static boolean isHidden(float[][] image, BitSet omitted) {
        double all = 0;
        double hidden = 0;
        for (int i = 0; i < image[0].length; i++) {
            double light = (double) image[0][i] + image[1][i] + image[2][i];
            all += light;
            hidden += omitted.get(i) ? light : 0;
        }
        return hidden > MAX_HIDDEN * all;
    }

    /** Returns cells of so many pixels that all images fit into the memory. */
    private static PixelMeans grid(Film picture, int images) {
        int side = 1;
        while ((long) images * 3 * Float.BYTES * Math.ceilDiv(picture.width(), side) * Math.ceilDiv(picture.height(), side) > MAX_BYTES) {
            side++;
        }
        return new PixelMeans(Math.ceilDiv(picture.width(), side), Math.ceilDiv(picture.height(), side));
    }

    private static PixelCache withoutFinerSamples(PixelCache cache) {
        return new PixelCache(cache.geometry(), cache.tiles(), new FineTile[0], cache.shown(), cache.mirrored());
    }

    /** Returns the contributions to the picture of an edited scene, of lights of which nothing but values differ. */
    private Map<Contribution, float[][]> scaledTo(Scene edited) {
        Map<Contribution, float[][]> scaled = new HashMap<>();
        if (edited.camera().equals(scene.camera()) && edited.picture().equals(scene.picture()) && edited.stage().equals(scene.stage())
                && edited.hasSameShapes(scene)
                && withoutDome(edited.world()).equals(withoutDome(scene.world()))) {
            for (Contribution part : Contribution.shining(edited)) {
                double[] factors = images.containsKey(part) ? factors(edited, part) : UNKNOWN;
                if (Double.isFinite(factors[0] + factors[1] + factors[2])) {
                    scaled.put(part, scaled(image(part), factors));
                }
            }
        }
        return scaled;
    }

    private static World withoutDome(World world) {
        return world.mapIntensities(_ -> 1).withDome(World.DEFAULT.dome());
    }

    /** Returns the factors of red, green and blue of a light or an environment; not finite if they are unknown. */
    private double[] factors(Scene edited, Contribution part) {
        Optional<Light> light = part.light(scene);
        if (light.isEmpty()) {
            double factor = ratio(part.values(scene).intensity(), part.values(edited).intensity());
            boolean isTurned = part instanceof Contribution.OfEnvironment && !edited.world().dome().equals(scene.world().dome());
            return isTurned ? UNKNOWN : new double[] {factor, factor, factor};
        }
        Light before = scene.rig().effectiveLight(light.get());
        Light after = edited.rig().effectiveLight(part.light(edited).orElseThrow());
        Rgb old = before.weight();
        Rgb weight = after.weight();
        return LightValues.areOnlyDifference(before, after)
                ? new double[] {ratio(old.r(), weight.r()), ratio(old.g(), weight.g()), ratio(old.b(), weight.b())} : UNKNOWN;
    }

    private static double ratio(double before, double after) {
        return before == after ? 1 : after / before;
    }

    private static float[][] scaled(float[][] image, double[] factors) {
        float[][] scaled = new float[3][];
        for (int c = 0; c < 3; c++) {
            scaled[c] = factors[c] == 1 ? image[c] : image[c].clone();
            for (int i = 0; factors[c] != 1 && i < scaled[c].length; i++) {
                scaled[c][i] *= (float) factors[c];
            }
        }
        return scaled;
    }

    PixelMeans grid() {
        return grid;
    }

    Scene scene() {
        return scene;
    }

    /** Returns a contribution that shines, {@code float[channel][cell]}; not to be modified. */
    float[][] image(Contribution part) {
        return requireNonNull(images.get(part));
    }

    /** Returns the picture whose contributions they are, {@code float[channel][cell]}. */
    float[][] picture(PixelCache cache) {
        return grid.of(omitsFinerSamples ? withoutFinerSamples(cache).film() : cache.film());
    }

    /** Returns the cells that do not count: pixels with finer samples, whose composition would take most of the time. */
    BitSet skipped(PixelCache cache) {
        return omitsFinerSamples ? finerPixels(cache) : new BitSet();
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
}
