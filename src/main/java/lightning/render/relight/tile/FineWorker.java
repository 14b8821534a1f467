package lightning.render.relight.tile;

import java.util.Arrays;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.engine.Crew;
import lightning.render.image.Film;
import lightning.render.shading.EdgeMap;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Antialias;

/**
 * Builds and updates the finer samples of tiles, after the pixels' centres are known (anti-aliasing). One for each
 * thread.
 *
 * <p>Which pixels have them follows from the scene alone. The samples of pixels at an edge of what is hit stay while
 * lights are edited and are updated like any rows; those at an edge of a light alone follow it, and are traced anew
 * in tiles where other pixels need them than before.
 */
final class FineWorker {
    private static final short[] NO_PIXELS = new short[0];

    private final Job job;
    private final Crew<TileWorker> crew;
    private final EdgeMap edges;
    private final EdgeMap known;

    /**
     * @param edges the edges that there are now; unread where all pixels have several samples
     * @param known the edges of the picture before, or null
     */
    FineWorker(Job job, Crew<TileWorker> crew, EdgeMap edges, EdgeMap known) {
        this.job = job;
        this.crew = crew;
        this.edges = edges;
        this.known = known;
    }

    /**
     * The finer samples of a tile; null where the work was cancelled.
     *
     * @param center    the centres of the tile's pixels after the update, or null where none are traced
     * @param oldCenter the same before, or null
     * @param old       the finer samples before, or null
     */
    FineTile tile(int tile, CachedTile center, CachedTile oldCenter, FineTile old) {
        boolean stay = old != null && (!job.coding() || edges.alike(tile, known));
        short[] shapePixels = stay ? old.shapes().pixels() : shapePixels(tile);
        short[] lightPixels = stay ? old.lights().pixels() : lightPixels(tile);
        FineSamples oldShapes = old != null && Arrays.equals(shapePixels, old.shapes().pixels()) ? old.shapes() : null;
        FineSamples oldLights = old != null && Arrays.equals(lightPixels, old.lights().pixels()) ? old.lights() : null;
        boolean same = oldShapes != null && oldLights != null && (center == null || center.film == oldCenter.film);
        int perPixel = job.sampling().perPixel();
        SampledFilm film = same ? SampledFilm.from(old, perPixel) : SampledFilm.over(center, old, perPixel);
        FineSamples shapes = samples(tile, shapePixels, oldShapes, film);
        FineSamples lights = samples(tile, lightPixels, oldLights, film);
        return job.progress().isCancelled() ? null : new FineTile(shapes, lights, film.film());
    }

    private short[] shapePixels(int tile) {
        return job.sampling().antialias() == Antialias.EDGES ? edges.shapeEdges(tile)
                : EdgeMap.all(job.scene().picture().width(), job.scene().picture().height(), tile);
    }

    private short[] lightPixels(int tile) {
        return job.sampling().antialias() == Antialias.EDGES ? edges.lightEdges(tile) : NO_PIXELS;
    }

    /** @param old the samples of the same pixels before, or null */
    private FineSamples samples(int tile, short[] pixels, FineSamples old, SampledFilm film) {
        int together = SampleMean.pixelsTogether(job.sampling().perPixel());
        TileWorker worker = crew.forTile(tile);
        CachedTile[] blocks = new CachedTile[(pixels.length + together - 1) / together];
        for (int b = 0; b < blocks.length; b++) {
            int from = b * together;
            int to = Math.min(pixels.length, from + together);
            var places = new SamplePlaces(tile % job.tilesX() * Film.TILE, tile / job.tilesX() * Film.TILE, pixels, from, to,
                    job.sampling().grid());
            blocks[b] = old == null ? worker.fine(places) : worker.relight(places, old.blocks()[b]);
            if (job.progress().isCancelled()) {
                // New samples that were given up have no colours, and no film before to take them from.
                break;
            }
            if (worker.recolored()) {
                film.write(pixels, from, to, worker.colors());
            } else {
                film.keep(pixels, from, to);
            }
        }
        return new FineSamples(old == null ? pixels : old.pixels(), blocks);
    }
}
