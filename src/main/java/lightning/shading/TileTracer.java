package lightning.shading;

import lightning.image.Film;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.MaterialTable;
import lightning.trace.PacketTracer;
import lightning.trace.TileVisibility;

/** Traces one tile after the other and keeps nothing but their pixels. One for each thread. */
final class TileTracer {
    private final Sight sight;
    private final Sampling sampling;
    private final Side eyes;
    private final Side mirrors;
    private final EdgeCoder coder = new EdgeCoder();
    private final ScratchColumns columns = new ScratchColumns();
    private final HitRows[] levels;
    private final LightLayer[] layers;
    private final float[][] samples;
    private long eye;
    private long reflected;

    TileTracer(Geometry geometry, Sight sight, Sampling sampling) {
        this.sight = sight;
        this.sampling = sampling;
        Lamp[] lamps = Lamp.all(sight.scene());
        Lamp[] mirroredLamps = Lamp.all(sight.mirrored());
        PacketTracer tracer = new PacketTracer(geometry);
        Geometry direct = geometry.of(sight.scene());
        Geometry reflected = geometry.of(sight.mirrored());
        eyes = new Side(direct, sight.scene(), lamps, tracer);
        mirrors = sight.scene() == sight.mirrored() ? eyes : new Side(reflected, sight.mirrored(), mirroredLamps, tracer);
        levels = new HitRows[sight.scene().picture().depth() + 1];
        layers = new LightLayer[Math.max(lamps.length, mirroredLamps.length)];
        samples = sampling.isFine() ? new float[3][Film.TILE_PIXELS] : null;
    }

    /** The rays cast so far. */
    TraceCounts rays() {
        return new TraceCounts(eye, reflected, eyes.lights.shadowRays() + (mirrors == eyes ? 0 : mirrors.lights.shadowRays()));
    }

    /** Traces the centres of a tile's pixels. */
    void centers(Film film, int tile, Progress progress) {
        centers(film, tile, false, progress);
    }

    /** Traces the centres of a tile's pixels; returns what anti-aliasing sees of them. */
    EdgeCodes coded(Film film, int tile, Progress progress) {
        coder.begin();
        centers(film, tile, true, progress);
        return coder.codes();
    }

    private void centers(Film film, int tile, boolean coded, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE;
        int y0 = tile / film.tilesX() * Film.TILE;
        eyes.visibility.eye(x0, y0, Film.TILE, (count, textured) -> level(0));
        eye += (long) Math.min(Film.TILE, film.width() - x0) * Math.min(Film.TILE, film.height() - y0);
        shade(coded, new float[][] {film.red(tile), film.green(tile), film.blue(tile)}, progress);
    }

    /** Makes some pixels of a tile of all their samples; {@code pixels} are indices in the tile, ascending. */
    void fine(Film film, int tile, short[] pixels, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE;
        int y0 = tile / film.tilesX() * Film.TILE;
        float[][] pixel = {film.red(tile), film.green(tile), film.blue(tile)};
        int together = SampleMean.pixelsTogether(sampling.perPixel());
        for (int from = 0; from < pixels.length && !progress.isCancelled(); from += together) {
            int to = Math.min(pixels.length, from + together);
            eyes.visibility.fine(x0, y0, pixels, from, to, sampling.grid(), (count, textured) -> level(0));
            eye += (long) (to - from) * sampling.perPixel();
            shade(false, samples, progress);
            SampleMean.write(pixels, from, to, sampling.perPixel(), samples, pixel);
        }
    }

    /** From the first level's rows to colours. */
    private void shade(boolean coded, float[][] colors, Progress progress) {
        int deepest = mirrors(coded);
        float[][] cr = mirrors.composer.unfollowed(levels[deepest]);
        for (int k = deepest; k > 0 && !progress.isCancelled(); k--) {
            compose(k, mirrors, coded, cr, progress);
            cr = mirrors.composer.followed(levels[k - 1], levels[k], sight.mirrored().world());
        }
        compose(0, eyes, coded, cr, progress);
        if (!progress.isCancelled()) {
            eyes.composer.toFilm(levels[0], sight.scene().world(), colors[0], colors[1], colors[2]);
        }
    }

    /** Follows the mirrors; returns the deepest level that was reached. */
    private int mirrors(boolean coded) {
        int deepest = 0;
        if (coded) {
            coder.shapes(0, levels[0]);
        }
        while (deepest < sight.scene().picture().depth() && levels[deepest].reflective > 0) {
            HitRows above = levels[deepest++];
            int next = deepest;
            reflected += above.reflective;
            mirrors.visibility.mirrored(above, null, (count, textured) -> level(next));
            if (coded) {
                coder.shapes(deepest, levels[deepest]);
            }
        }
        return deepest;
    }

    private HitRows level(int k) {
        if (levels[k] == null) {
            levels[k] = new HitRows(Film.TILE_PIXELS, true, sampling.antialias() == Antialias.EDGES);
        }
        return levels[k];
    }

    private void compose(int level, Side side, boolean coded, float[][] cr, Progress progress) {
        columns.reset();
        for (int l = 0; l < side.lamps.length && !progress.isCancelled(); l++) {
            LightRows layer = side.lamps[l].isDark() ? null : side.lights.full(levels[level], side.lamps[l], columns);
            layers[l] = layer;
            if (coded && layer != null) {
                coder.light(level, l, levels[level], layer, side.materials);
            }
        }
        if (!progress.isCancelled()) {
            side.composer.level(levels[level], side.lamps, layers, null, side.world, cr);
        }
    }

    /** What is needed of the scene that the eye sees, or of the one that mirrors show. */
    private static final class Side {
        private final TileVisibility visibility;
        private final LightKernel lights;
        private final TileComposer composer;
        private final MaterialTable materials;
        private final World world;
        private final Lamp[] lamps;

        Side(Geometry geometry, Scene scene, Lamp[] lamps, PacketTracer tracer) {
            visibility = new TileVisibility(geometry, scene, tracer);
            lights = new LightKernel(geometry, tracer, ViewEffects.ALL);
            composer = new TileComposer(geometry.materials(), ViewEffects.ALL);
            materials = geometry.materials();
            world = scene.world();
            this.lamps = lamps;
        }
    }
}
