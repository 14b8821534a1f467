package lightning.render.relight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.shading.FilmSum;
import lightning.render.shading.LightWeight;
import lightning.scene.Contribution;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Contributions of all lights to a picture, computed from its films. The picture without a light has the same samples.
 *
 * @param lights            one contribution for each light and each environment of the scene, in its order; the visible background is part of an
 *                          environment's
 * @param idleLights        lights that shine, but change the display color of no pixel when all of them are off; none is solo, since others would
 *                          shine without it
 * @param changeWhenIdleOff change of the picture when all of these are off
 */
public record LightContributions(List<LightContribution> lights, List<Contribution> idleLights,
        FilmChange changeWhenIdleOff) {

    /**
     * Region of a picture.
     *
     * @param left  the first column, with {@code top} as the first row
     * @param right the column after the last, with {@code bottom} as the row after the last
     */
    public record Region(int left, int top, int right, int bottom) {
        /** Returns the region of a whole film. */
        public static Region ofFilm(Film film) {
            return new Region(0, 0, film.width(), film.height());
        }

        /**
         * Returns the sum of a film in the part of this region that a tile covers: red, green and blue.
         *
         * @param x0   left of the tile, as {@code y0} is its top
         * @param film null if it is black
         */
        double[] total(int x0, int y0, PictureSettings picture, float @Nullable [][] film) {
            double[] total = new double[3];
            int first = Math.clamp(left - x0, 0, Film.TILE_SIZE);
            int end = Math.clamp(Math.min(right, picture.width()) - x0, 0, Film.TILE_SIZE);
            int firstLine = Math.clamp(top - y0, 0, Film.TILE_SIZE);
            int endLine = Math.clamp(Math.min(bottom, picture.height()) - y0, 0, Film.TILE_SIZE);
            for (int y = firstLine; film != null && y < endLine; y++) {
                for (int i = y * Film.TILE_SIZE + first; i < y * Film.TILE_SIZE + end; i++) {
                    for (int c = 0; c < 3; c++) {
                        total[c] += film[c][i];
                    }
                }
            }
            return total;
        }

        double luminance(Film film) {
            double sum = 0;
            for (int y = Math.max(0, top); y < Math.min(film.height(), bottom); y++) {
                for (int x = Math.max(0, left); x < Math.min(film.width(), right); x++) {
                    sum += 0.2126 * film.red(x, y) + 0.7152 * film.green(x, y) + 0.0722 * film.blue(x, y);
                }
            }
            return sum;
        }
    }

    /**
     * Computes the contributions of all lights to a picture.
     *
     * @param cache    cache of a finished picture; not modified
     * @param options  options of its render
     * @param view     view transform of its display
     * @param region   region whose shares are computed too
     * @param progress counts tiles
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public static LightContributions of(PixelCache cache, RenderOptions options, ViewTransform view, Region region, Progress progress) {
        Scene scene = cache.scene();
        Film picture = cache.film();
        PictureFilms films = new PictureFilms(cache, options);
        Progress silent = progress.cancellationOnly();
        Region whole = Region.ofFilm(picture);
        LightShares ofImage = LightShares.of(films, picture, whole, silent);
        LightShares ofRegion = region.equals(whole) ? ofImage : LightShares.of(films, picture, region, silent);
        List<Contribution> sources = Contribution.sources(scene);
        List<Contribution> shining = sources.stream().filter(source -> shines(scene, source)).toList();
        List<FilmChange> changes = changes(films, picture, shining.stream().map(List::of).toList(), options, view, progress);
        List<LightContribution> all = sources.stream().map(source -> new LightContribution(source, shining.contains(source),
                ofImage.of(source), ofRegion.of(source), shining.contains(source) ? changes.get(shining.indexOf(source)) : FilmChange.NONE))
                .toList();
        List<Contribution> idle = new ArrayList<>(all.stream()
                .filter(c -> c.light().light(scene).filter(light -> !scene.rig().effectiveLight(light).solo()).isPresent())
                .filter(c -> c.shines() && c.changeWhenOff().isInvisible())
                .sorted(Comparator.comparingDouble(LightContribution::imageShare)).map(LightContribution::light).toList());
        FilmChange together = FilmChange.NONE;
        // Lights that are invisible alone may be visible together: the brightest ones then stay.
        while (!idle.isEmpty()) {
            together = changes(films, picture, List.of(idle), options, view, silent).getFirst();
            if (together.isInvisible()) {
                break;
            }
            idle.removeLast();
            together = FilmChange.NONE;
        }
        return new LightContributions(all, List.copyOf(idle), together);
    }

    /** Returns the changes of the picture without some contributions each, for several of these. */
    private static List<FilmChange> changes(PictureFilms films, Film picture, List<List<Contribution>> switchedOff, RenderOptions options,
            ViewTransform view, Progress progress) {
        BitSet[] off = switchedOff.stream().map(films.parts()::of).toArray(BitSet[]::new);
        LightWeight[] weights = films.parts().weights();
        try (WorkerPool workers = new WorkerPool(options.threads())) {
            FilmChange.Counter[][] counters = new FilmChange.Counter[workers.count()][off.length];
            FilmSum[] sums = new FilmSum[workers.count()];
            for (int worker = 0; worker < sums.length; worker++) {
                Arrays.setAll(counters[worker], _ -> new FilmChange.Counter(view));
                sums[worker] = new FilmSum();
            }
            films.forEachTile(workers, progress, (worker, tile, its) -> {
                float[][] sum = new float[3][Film.TILE_PIXELS];
                FilmChange.Counter first = null;
                for (int s = 0; s < off.length; s++) {
                    BitSet dark = off[s];
                    if (dark.stream().allMatch(film -> its.get(film) == null)) {
                        continue;
                    }
                    FilmChange.Counter counter = counters[worker][s];
                    if (first == null) {
                        first = counter;
                        float[][] before = {picture.red(tile), picture.green(tile), picture.blue(tile)};
                        if (films.showsEarlierMirrors()) {
                            before = new float[3][Film.TILE_PIXELS];
                            sums[worker].add(weights, its, Film.TILE_PIXELS, before);
                        }
                        first.start(picture, tile, before);
                    } else {
                        counter.start(first);
                    }
                    sums[worker].add(weights, film -> dark.get(film) ? null : its.get(film), Film.TILE_PIXELS, sum);
                    counter.add(sum);
                }
            });
            for (int worker = 1; worker < sums.length; worker++) {
                for (int s = 0; s < off.length; s++) {
                    counters[0][s].add(counters[worker][s]);
                }
            }
            return Arrays.stream(counters[0]).map(counter -> counter.total(picture)).toList();
        }
    }

    /** Returns whether a contribution shines or, of an environment that a solo mutes, shows its image. */
    private static boolean shines(Scene scene, Contribution source) {
        int environment = source.environmentIndex(scene);
        return environment < 0 ? source.isShining(scene)
                : scene.world().environments().get(environment).on() && scene.world().environments().get(environment).intensity() > 0;
    }

    /** Returns the scene with some of its lights switched off. */
    public static Scene switchOff(Scene scene, Collection<Contribution> lights) {
        Set<Contribution> off = Set.copyOf(lights);
        return scene.withLights(scene.lights().stream().map(l -> off.contains(Contribution.of(l)) ? l.withOn(false) : l).toList());
    }
}
