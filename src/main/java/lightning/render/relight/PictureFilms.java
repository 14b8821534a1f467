package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.cache.PixelCache;
import lightning.render.cache.SampleBlock;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.shading.FilmParts;
import lightning.render.shading.FilmSum;
import lightning.render.shading.LightWeight;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.composition.FilmColors;
import lightning.render.trace.SamplePositions;
import lightning.scene.Contribution;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Films of a cached picture. Films that tiles keep are read, and the others are composed from rows; this casts no ray and changes nothing. Mirrors
 * that show an earlier scene are a film of their own, which belongs to no light.
 */
public final class PictureFilms {
    private final PixelCache cache;
    private final RenderOptions options;
    private final FilmParts parts;
    private final BitSet chosen;

    /**
     * @param cache   of a picture, with or without its finer samples
     * @param options of its render
     * @throws IllegalStateException if mirror levels are stored as hit shapes
     */
    public PictureFilms(PixelCache cache, RenderOptions options) {
        this.cache = cache;
        this.options = options;
        parts = cache.parts();
        chosen = parts.shining();
        if (!cache.allTiles().stream().allMatch(CachedTile::storesRows)) {
            throw new IllegalStateException("mirror levels are stored as hit shapes");
        }
    }

    private PictureFilms(PixelCache cache, RenderOptions options, FilmParts parts, BitSet chosen) {
        this.cache = cache;
        this.options = options;
        this.parts = parts;
        this.chosen = chosen;
    }

    /** Returns these films, of which only some are read; others count as black. */
    public PictureFilms only(BitSet films) {
        BitSet some = parts.shining();
        some.and(films);
        return new PictureFilms(cache, options, parts, some);
    }

    /** Returns whether mirrors show an earlier scene, as a film that belongs to no contribution. */
    boolean showsEarlierMirrors() {
        return cache.areMirrorsOutdated();
    }

    /** Returns the films of the picture's scene. */
    public FilmParts parts() {
        return parts;
    }

    /** Receiver of the films of a tile. */
    @FunctionalInterface
    public interface Receiver {
        /**
         * @param worker number of the thread
         * @param films  red, green and blue of the tile's 1024 pixels in each film, without its weight; null for black films. Valid during the
         *               call
         */
        void receive(int worker, int tile, FilmSum.Films films);
    }

    /**
     * Reads the films of all tiles, on all threads.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public void forEachTile(WorkerPool workers, Progress progress, Receiver receiver) {
        forEachTile(workers, IntStream.range(0, Math.max(cache.tileCount(), cache.fineCount())).toArray(), progress, receiver);
    }

    /** Reads the films of some tiles, as above. */
    void forEachTile(WorkerPool workers, int[] tiles, Progress progress, Receiver receiver) {
        List<EngineWorkers<TileReader>> readers = EngineWorkers.perThread(workers.count(), options.engines(), TileReader::new);
        workers.run(tiles.length, (worker, i) -> receiver.receive(worker, tiles[i], readers.get(worker).forTile(tiles[i]).read(tiles[i])),
                progress);
    }

    /**
     * Returns the sum of the films, times their weights.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public Film sum(WorkerPool workers, Progress progress) {
        Film film = Film.black(cache.scene().picture().width(), cache.scene().picture().height());
        LightWeight[] weights = parts.weights();
        FilmSum[] sums = new FilmSum[workers.count()];
        Arrays.setAll(sums, _ -> new FilmSum());
        forEachTile(workers, progress, (worker, tile, films) -> sums[worker].add(weights, films, Film.TILE_PIXELS,
                new float[][] {film.red(tile), film.green(tile), film.blue(tile)}));
        return film;
    }

    /**
     * Returns the sum of the pixels of each film in a region, without its weight: red, green and blue, {@code double[films][3]}.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    double[][] totals(LightContributions.Region region, Progress progress) {
        PictureSettings picture = cache.scene().picture();
        int tilesX = Film.tilesAlong(picture.width());
        double[][] totals = new double[parts.count()][3];
        double[][][] ofTiles = new double[Math.max(cache.tileCount(), cache.fineCount())][parts.count()][];
        try (WorkerPool workers = new WorkerPool(options.threads())) {
            forEachTile(workers, progress, (_, tile, films) -> Arrays.setAll(ofTiles[tile],
                    film -> region.total(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE, picture, films.get(film))));
        }
        for (double[][] tile : ofTiles) {
            for (int film = 0; film < totals.length; film++) {
                for (int c = 0; c < 3; c++) {
                    totals[film][c] += tile[film][c];
                }
            }
        }
        return totals;
    }

    /**
     * Composes the image of each light and each environment that shines, one after the other: with its visible face, bulbs or background.
     *
     * @param progress counts them
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public void forEachShining(Progress progress, BiConsumer<Contribution, Film> receiver) {
        List<Contribution> shining = Contribution.shining(cache.scene());
        try (WorkerPool workers = new WorkerPool(options.threads())) {
            for (int i = 0; i < shining.size(); i++) {
                progress.report(i, shining.size());
                receiver.accept(shining.get(i), only(parts.of(shining.get(i))).sum(workers, progress.cancellationOnly()));
            }
        }
        progress.report(shining.size(), shining.size());
    }

    /** Reads tiles with scratch memory: one for each thread. */
    private final class TileReader {
        private final TileRecomposer recomposer;
        private final FilmColors films = new FilmColors();
        private final FilmColors samples = new FilmColors();

        TileReader(Engine engine) {
            recomposer = TileRecomposer.of(cache, engine, options.view());
        }

        FilmSum.Films read(int tile) {
            films.clear(parts.count());
            int tilesX = Film.tilesAlong(cache.scene().picture().width());
            SamplePositions centers = SamplePositions.centers(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE);
            FineTile fine = cache.fineCount() == 0 ? null : cache.fineTile(tile);
            CachedTile center = cache.tileCount() == 0 ? null : cache.tile(tile);
            boolean keepsCenter = center != null && center.films() != null && knows(center.films().known());
            if (fine == null && keepsCenter) {
                return film -> chosen.get(film) ? requireNonNull(requireNonNull(center).films()).get(film) : null;
            }
            if (center != null && keepsCenter) {
                for (int film = chosen.nextSetBit(0); film >= 0; film = chosen.nextSetBit(film + 1)) {
                    copy(requireNonNull(center.films()).get(film), film);
                }
            } else if (center != null) {
                compose(center, centers, films);
            }
            if (fine != null) {
                addSamples(fine, centers);
            }
            return films::get;
        }

        private boolean knows(BitSet known) {
            BitSet missing = (BitSet) chosen.clone();
            missing.andNot(known);
            return missing.isEmpty();
        }

        private void copy(float @Nullable [][] from, int film) {
            if (from != null) {
                float[][] to = films.toWrite(film);
                for (int c = 0; c < 3; c++) {
                    System.arraycopy(from[c], 0, to[c], 0, Film.TILE_PIXELS);
                }
            }
        }

        private void addSamples(FineTile fine, SamplePositions centers) {
            StoredFilms known = fine.films() != null ? fine.films()
                    : FineTile.films(composed(fine.first(), centers), composed(fine.rest(), centers), parts.count());
            for (int film = chosen.nextSetBit(0); film >= 0; film = chosen.nextSetBit(film + 1)) {
                set(fine.first().pixels(), film, known.get(film));
            }
        }

        /** @param from colors of the pixels, in their order; null if they are black */
        private void set(short[] pixels, int film, float @Nullable [][] from) {
            if (from == null && films.get(film) == null) {
                return;
            }
            float[][] to = films.toWrite(film);
            for (int c = 0; c < 3; c++) {
                for (int i = 0; i < pixels.length; i++) {
                    to[c][pixels[i]] = from == null ? 0 : from[c][i];
                }
            }
        }

        /** Returns samples with the means of the films that are read. */
        private FineSamples composed(FineSamples stage, SamplePositions centers) {
            return stage.map(block -> {
                compose(block.rows(), block.positions(centers, stage.cells()), samples);
                return new SampleBlock(block.pixels(), block.rows(),
                        new StoredFilms(samples.means(parts.count(), block.pixels().length, stage.cells().count()), chosen));
            });
        }

        private void compose(CachedTile tile, SamplePositions places, FilmColors to) {
            TileLevel[] levels = tile.levels().clone();
            FilmColors[] images = !cache.areMirrorsOutdated() ? recomposer.composeImages(places, levels, chosen) : null;
            recomposer.composeFilms(tile.levels()[0], places, chosen, images, null, null, tile.fog(), to);
        }
    }

    /** Returns the scene that the films show. */
    public Scene scene() {
        return cache.scene();
    }
}
