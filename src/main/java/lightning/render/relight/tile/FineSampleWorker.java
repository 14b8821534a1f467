package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.cache.SampleBlock;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.SampleMean;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.composition.EdgeDetector;
import lightning.render.shading.composition.FilmMixer;
import lightning.render.trace.SampleCells;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Builds and updates the finer samples of tiles for anti-aliasing, after the pixel centers. Use one instance per thread.
 *
 * <p>The scene alone decides which pixels have them. Samples are cached and updated like other rows. A pixel that needs no samples
 * any more keeps them for a while, because a light that moves back needs them again.
 */
final class FineSampleWorker {
    /** Blocks in which a smaller share of the pixels use their samples are removed. */
    private static final double MIN_USED_SHARE = 0.5;
    /** Blocks with a smaller share of the possible pixels are joined if there are many blocks. */
    private static final double MIN_BLOCK_SHARE = 0.25;

    private final RenderJob job;
    private final EngineWorkers<TileWorker> tileWorkers;
    private final EdgeDetector edges;
    private final @Nullable EdgeDetector previousEdges;
    private final SampleCells firstCells;
    private final SampleCells restCells;
    private final boolean refines;
    private final boolean isOnlyAtEdges;
    /** True if any film of any samples changed since the start of a tile. */
    private boolean hasNewFilms;

    /**
     * @param edges the current edges; unread if all pixels have several samples
     * @param known the edges of the previous picture
     */
    FineSampleWorker(RenderJob job, EngineWorkers<TileWorker> tileWorkers, EdgeDetector edges, @Nullable EdgeDetector known) {
        this.job = job;
        this.tileWorkers = tileWorkers;
        this.edges = edges;
        this.previousEdges = known;
        firstCells = SampleCells.first(job.scene());
        restCells = SampleCells.rest(job.scene());
        refines = restCells.count() > 0;
        isOnlyAtEdges = job.scene().hasSamplesOnlyAtEdges();
    }

    /**
     * Builds the finer samples of a tile; null if the work was canceled.
     *
     * @param center    the centers of the tile's pixels after the update, or null if none are traced
     * @param oldCenter the centers before the update
     * @param old       the finer samples before the update
     */
    @Nullable
    FineTile buildTile(int tile, @Nullable CachedTile center, @Nullable CachedTile oldCenter, @Nullable FineTile old) {
        hasNewFilms = false;
        StoredFilms known = old == null ? null : old.films();
        if (job.onlyReweights() && old != null && known != null) {
            boolean isSame = job.films().reweighted().stream().allMatch(film -> known.get(film) == null)
                    && (center == null || center.film() == requireNonNull(oldCenter).film());
            return isSame ? old
                    : FineTile.of(center == null ? null : center.film(), old.first(), old.rest(), known, tileWorkers.forTile(tile).mixer());
        }
        boolean reusesPixels = old != null && (!isOnlyAtEdges || edges.hasSameEdges(tile, requireNonNull(previousEdges)));
        short[] pixels = old != null && reusesPixels ? old.first().pixels() : pixels(tile);
        FineSamples first = update(tile, firstCells, pixels, old == null ? FineSamples.none(firstCells) : old.first());
        if (job.progress().isCanceled()) {
            return null;
        }
        FineSamples oldRest = old == null ? FineSamples.none(restCells) : old.rest();
        FineSamples rest = refines ? update(tile, restCells, visiblyDifferent(first), oldRest) : oldRest;
        if (job.progress().isCanceled()) {
            return null;
        }
        boolean keepsFilms = old != null && known != null && !hasNewFilms && job.films().isSame()
                && Arrays.equals(first.pixels(), old.first().pixels()) && Arrays.equals(rest.pixels(), old.rest().pixels());
        boolean isUnchanged =
                keepsFilms && !job.films().reweights() && (center == null || center.film() == requireNonNull(oldCenter).film());
        if (isUnchanged) {
            return new FineTile(first, rest, known, requireNonNull(old).film());
        }
        FilmMixer mixer = tileWorkers.forTile(tile).mixer();
        StoredFilms films = keepsFilms ? requireNonNull(known) : FineTile.films(first, rest, mixer.films());
        return FineTile.of(center == null ? null : center.film(), first, rest, films, mixer);
    }

    private short[] pixels(int tile) {
        return isOnlyAtEdges ? edges.edges(tile)
                : EdgeDetector.allPixels(job.scene().picture().width(), job.scene().picture().height(), tile);
    }

    /** Returns the pixels whose first samples differ visibly. */
    private static short[] visiblyDifferent(FineSamples first) {
        BitSet different = new BitSet();
        BitSet used = first.pixelSet();
        int perPixel = first.cells().count();
        for (SampleBlock block : first.blocks()) {
            for (int i = 0; i < block.pixels().length; i++) {
                if (used.get(block.pixels()[i])
                        && EdgeColors.needMore(requireNonNull(block.rows().edges()).colors(), i * perPixel, perPixel)) {
                    different.set(block.pixels()[i]);
                }
            }
        }
        return EdgeDetector.toPixels(different);
    }

    /** Updates known samples and traces missing ones. If canceled, the result is incomplete. */
    private FineSamples update(int tile, SampleCells cells, short[] pixels, FineSamples old) {
        FineSamples needed = new FineSamples(cells, pixels, old.blocks());
        BitSet neededPixels = needed.pixelSet();
        BitSet missing = needed.pixelSet();
        int batchSize = SampleMean.pixelsPerBatch(cells.count());
        // Blocks are sorted out when pixels change, whether films are known or not.
        boolean sorts = !job.onlyReweights();
        boolean isFragmented = sorts && old.blocks().length > 2 + 2 * Math.ceilDiv(pixels.length, batchSize);
        int minSize = isFragmented ? (int) (MIN_BLOCK_SHARE * batchSize) : 1;
        List<SampleBlock> blocks = new ArrayList<>();
        for (SampleBlock block : old.blocks()) {
            if (job.progress().isCanceled()) {
                return needed;
            }
            if (block.pixels().length >= minSize && (!sorts || isWorthKeeping(block, neededPixels))) {
                addTo(blocks, relight(tile, cells, block));
                for (short pixel : block.pixels()) {
                    missing.clear(pixel);
                }
            }
        }
        short[] added = EdgeDetector.toPixels(missing);
        for (int from = 0; from < added.length && !job.progress().isCanceled(); from += batchSize) {
            addTo(blocks, trace(tile, cells, Arrays.copyOfRange(added, from, Math.min(added.length, from + batchSize))));
        }
        return new FineSamples(cells, Arrays.equals(pixels, old.pixels()) ? old.pixels() : pixels, blocks.toArray(SampleBlock[]::new));
    }

    /** @param block null if the work was canceled */
    private static void addTo(List<SampleBlock> blocks, @Nullable SampleBlock block) {
        if (block != null) {
            blocks.add(block);
        }
    }

    private static boolean isWorthKeeping(SampleBlock block, BitSet neededPixels) {
        int count = 0;
        for (short pixel : block.pixels()) {
            count += neededPixels.get(pixel) ? 1 : 0;
        }
        return count > 0 && count >= MIN_USED_SHARE * block.pixels().length;
    }

    private SamplePositions positions(int tile, SampleCells cells, short[] pixels) {
        return new SamplePositions(tile % job.tilesX() * Film.TILE_SIZE, tile / job.tilesX() * Film.TILE_SIZE, pixels, cells);
    }

    private boolean decides(SampleCells cells) {
        return refines && cells == firstCells;
    }

    private @Nullable SampleBlock trace(int tile, SampleCells cells, short[] pixels) {
        TileWorker worker = tileWorkers.forTile(tile);
        CachedTile rows = worker.traceSamples(positions(tile, cells, pixels), decides(cells));
        return rows == null ? null : block(worker, cells, pixels, rows, null);
    }

    private @Nullable SampleBlock relight(int tile, SampleCells cells, SampleBlock old) {
        TileWorker worker = tileWorkers.forTile(tile);
        CachedTile rows = worker.relight(positions(tile, cells, old.pixels()), old.rows(), old.means(), decides(cells));
        return rows == null ? null : block(worker, cells, old.pixels(), rows, old.means());
    }

    /** Returns a block with the means of the films that a worker composed, and others from before. */
    private SampleBlock block(TileWorker worker, SampleCells cells, short[] pixels, CachedTile rows, @Nullable StoredFilms before) {
        if (before != null && worker.changedFilms().isEmpty() && job.films().isSame()) {
            return new SampleBlock(pixels, rows, before);
        }
        hasNewFilms = true;
        int films = worker.mixer().films();
        // What earlier mirrors show is composed with any other film.
        int[] origin = Arrays.copyOf(job.films().origin(), films);
        for (int film = job.films().origin().length; film < films; film++) {
            origin[film] = before == null || !job.areMirrorsOutdated() ? -1 : before.colors().length - films + film;
        }
        return new SampleBlock(pixels, rows, StoredFilms.after(before, origin, worker.changedFilms(), worker.composedFilms(),
                film -> worker.films().mean(film, pixels.length, cells.count())));
    }
}
