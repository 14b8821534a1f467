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
 * Builds and updates the finer samples of tiles, after the pixels' centers are known (anti-aliasing). One for each
 * thread.
 *
 * <p>Which pixels have them follows from the scene alone. The samples of pixels at an edge of what is hit stay while
 * lights are edited and are updated like any rows; those at an edge of a light alone follow it, and are traced anew
 * in tiles where other pixels need them than before.
 */
final class FineSampleWorker {
    private static final short[] NO_PIXELS = new short[0];

    private final RenderJob job;
    private final EngineWorkers<TileWorker> crew;
    private final EdgeDetector edges;
    private final EdgeDetector previousEdges;

    /**
     * @param edges the edges that there are now; unread where all pixels have several samples
     * @param known the edges of the picture before, or null
     */
    FineSampleWorker(RenderJob job, EngineWorkers<TileWorker> crew, EdgeDetector edges, EdgeDetector known) {
        this.job = job;
        this.crew = crew;
        this.edges = edges;
        this.previousEdges = known;
    }

    /**
     * The finer samples of a tile; null where the work was canceled.
     *
     * @param center    the centers of the tile's pixels after the update, or null where none are traced
     * @param oldCenter the same before, or null
     * @param old       the finer samples before, or null
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

    /** @param old the samples of the same pixels before, or null */
    private FineSamples samples(int tile, short[] pixels, FineSamples old, SampledTile film) {
        int batchSize = SampleMean.pixelsPerBatch(job.sampling().samplesPerPixel());
        TileWorker worker = crew.forTile(tile);
        CachedTile[] blocks = new CachedTile[(pixels.length + batchSize - 1) / batchSize];
        for (int b = 0; b < blocks.length; b++) {
            int from = b * batchSize;
            int to = Math.min(pixels.length, from + batchSize);
            var places = new SamplePositions(tile % job.tilesX() * Film.TILE_SIZE, tile / job.tilesX() * Film.TILE_SIZE, pixels, from, to,
                    job.sampling().grid());
            blocks[b] = old == null ? worker.traceSamples(places) : worker.relight(places, old.blocks()[b]);
            if (job.progress().isCanceled()) {
                // New samples that were given up have no colors, and no film before to take them from.
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
