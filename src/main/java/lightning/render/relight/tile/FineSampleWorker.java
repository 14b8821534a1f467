package lightning.render.relight.tile;

import java.util.Arrays;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.shading.EdgeDetector;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePositions;
import lightning.scene.AntialiasMode;

/**
 * Builds and updates the finer samples of tiles for anti-aliasing, after the pixel centers. Use one instance per thread.
 *
 * <p>The scene alone decides which pixels have them. Samples at shape edges are kept during light edits and updated like other
 * rows. Samples at light edges follow the light: in tiles where other pixels need them than before, they are traced again.
 */
final class FineSampleWorker {
    private static final short[] NO_PIXELS = new short[0];

    private final RenderJob job;
    private final EngineWorkers<TileWorker> tileWorkers;
    private final EdgeDetector edges;
    private final EdgeDetector previousEdges;

    /**
     * @param edges the current edges; unread if all pixels have several samples
     * @param known the edges of the previous picture, or null
     */
    FineSampleWorker(RenderJob job, EngineWorkers<TileWorker> tileWorkers, EdgeDetector edges, EdgeDetector known) {
        this.job = job;
        this.tileWorkers = tileWorkers;
        this.edges = edges;
        this.previousEdges = known;
    }

    /**
     * Builds the finer samples of a tile; null if the work was canceled.
     *
     * @param center    the centers of the tile's pixels after the update, or null if none are traced
     * @param oldCenter the centers before the update, or null
     * @param old       the finer samples before the update, or null
     */
    FineTile buildTile(int tile, CachedTile center, CachedTile oldCenter, FineTile old) {
        boolean reusesPixels = old != null && (!job.detectsEdges() || edges.hasSameEdges(tile, previousEdges));
        short[] shapePixels = reusesPixels ? old.shapes().pixels() : shapePixels(tile);
        short[] lightPixels = reusesPixels ? old.lights().pixels() : lightPixels(tile);
        FineSamples oldShapes = old != null && Arrays.equals(shapePixels, old.shapes().pixels()) ? old.shapes() : null;
        FineSamples oldLights = old != null && Arrays.equals(lightPixels, old.lights().pixels()) ? old.lights() : null;
        boolean isUnchanged = oldShapes != null && oldLights != null && (center == null || center.film == oldCenter.film);
        int perPixel = job.sampling().samplesPerPixel();
        SampledTile film = isUnchanged ? SampledTile.ofPrevious(old, perPixel) : SampledTile.ofCenters(center, old, perPixel);
        FineSamples shapes = samples(tile, shapePixels, oldShapes, film);
        FineSamples lights = samples(tile, lightPixels, oldLights, film);
        return job.progress().isCanceled() ? null : new FineTile(shapes, lights, film.film());
    }

    private short[] shapePixels(int tile) {
        return job.sampling().antialias() == AntialiasMode.EDGES ? edges.shapeEdges(tile)
                : EdgeDetector.allPixels(job.scene().picture().width(), job.scene().picture().height(), tile);
    }

    private short[] lightPixels(int tile) {
        return job.sampling().antialias() == AntialiasMode.EDGES ? edges.lightEdges(tile) : NO_PIXELS;
    }

    /** @param old old samples of the same pixels, or null */
    private FineSamples samples(int tile, short[] pixels, FineSamples old, SampledTile film) {
        int batchSize = SampleMean.pixelsPerBatch(job.sampling().samplesPerPixel());
        TileWorker worker = tileWorkers.forTile(tile);
        CachedTile[] blocks = new CachedTile[(pixels.length + batchSize - 1) / batchSize];
        for (int b = 0; b < blocks.length; b++) {
            int from = b * batchSize;
            int to = Math.min(pixels.length, from + batchSize);
            var places = new SamplePositions(tile % job.tilesX() * Film.TILE_SIZE, tile / job.tilesX() * Film.TILE_SIZE, pixels, from, to,
                    job.sampling().grid());
            blocks[b] = old == null ? worker.traceSamples(places) : worker.relight(places, old.blocks()[b]);
            if (job.progress().isCanceled()) {
                // New samples that were canceled have no colors and no previous film to copy them from.
                break;
            }
            if (worker.hasNewColors()) {
                film.write(pixels, from, to, worker.colors());
            } else {
                film.copyPrevious(pixels, from, to);
            }
        }
        return new FineSamples(old == null ? pixels : old.pixels(), blocks);
    }
}
