package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.EdgeCoder;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.Images;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.shading.SampleMean;
import lightning.render.shading.ScratchColumns;
import lightning.render.shading.SeenScenes;
import lightning.render.shading.TileComposer;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Bounce;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePlaces;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Antialias;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/** Traces one tile after the other and keeps nothing but their pixels. One for each thread and engine. */
final class TileTracer {
    private final Sampling sampling;
    private final int depth;
    private final Side eye;
    private final Side mirrors;
    private final EdgeCoder coder = new EdgeCoder();
    private final ScratchColumns columns = new ScratchColumns();
    private final HitRows[] levels;
    private final LightLayer[] layers;
    private final float[][] samples;
    private long eyeRays;
    private long reflected;

    /** What is needed of the first level, or of those in mirrors. */
    private static final class Side {
        private final Luminaire[] lights;
        private final Scene scene;
        private final World world;
        private final MaterialTable materials;
        private final TileVisibility visibility;
        private final LightKernel kernel;
        private final TileComposer composer;

        Side(Geometry geometry, Scene scene, Engine engine, Tracer tracer) {
            lights = Luminaire.all(scene);
            this.scene = scene;
            world = scene.world();
            materials = geometry.materials();
            visibility = new TileVisibility(geometry, scene, tracer);
            kernel = new LightKernel(geometry, tracer, engine.terms(), ViewEffects.ALL);
            composer = new TileComposer(materials, engine.sums(), ViewEffects.ALL);
        }
    }

    TileTracer(Geometry geometry, Geometry mirroredGeometry, SeenScenes scenes, Sampling sampling, Engine engine) {
        this.sampling = sampling;
        depth = scenes.scene().picture().depth();
        Tracer tracer = engine.tracer(geometry);
        eye = new Side(geometry, scenes.scene(), engine, tracer);
        mirrors = scenes.mirrored() == scenes.scene() ? eye : new Side(mirroredGeometry, scenes.mirrored(), engine, tracer);
        levels = new HitRows[depth + 1];
        layers = new LightLayer[Math.max(eye.lights.length, mirrors.lights.length)];
        samples = sampling.isFine() ? new float[3][Film.TILE_PIXELS] : null;
    }

    /** The rays cast so far. */
    TraceCounts rays() {
        return new TraceCounts(eyeRays, reflected, eye.kernel.shadowRays() + (mirrors == eye ? 0 : mirrors.kernel.shadowRays()));
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
        eye.visibility.eye(x0, y0, Film.TILE, (count, textured, clear) -> level(0));
        eyeRays += (long) Math.min(Film.TILE, film.width() - x0) * Math.min(Film.TILE, film.height() - y0);
        shade(SamplePlaces.centers(x0, y0), coded, new float[][] {film.red(tile), film.green(tile), film.blue(tile)}, progress);
    }

    /** Makes some pixels of a tile of all their samples; {@code pixels} are indices in the tile, ascending. */
    void fine(Film film, int tile, short[] pixels, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE;
        int y0 = tile / film.tilesX() * Film.TILE;
        float[][] pixel = {film.red(tile), film.green(tile), film.blue(tile)};
        int together = SampleMean.pixelsTogether(sampling.perPixel());
        for (int from = 0; from < pixels.length && !progress.isCancelled(); from += together) {
            int to = Math.min(pixels.length, from + together);
            var places = new SamplePlaces(x0, y0, pixels, from, to, sampling.grid());
            eye.visibility.fine(places, (count, textured, clear) -> level(0));
            eyeRays += (long) (to - from) * sampling.perPixel();
            shade(places, false, samples, progress);
            SampleMean.write(pixels, from, to, sampling.perPixel(), samples, pixel);
        }
    }

    /** From the first level's rows to colours. */
    private void shade(SamplePlaces places, boolean coded, float[][] colors, Progress progress) {
        if (coded) {
            coder.shapes(0, 0, levels[0], eye.materials);
        }
        Images images = images(0, 0, coded, progress);
        eye.composer.background(levels[0], eye.scene, places, colors);
        compose(eye, 0, 0, coded, images, colors, progress);
    }

    /** Follows the rays that go on from the rows of a level; what they bring. */
    private Images images(int level, int place, boolean coded, Progress progress) {
        HitRows rows = levels[level];
        if (level == depth || rows.reflective == 0) {
            return mirrors.composer.unfollowed(rows, level);
        }
        Images images = mirrors.composer.followed(rows, mirrors.world, level);
        for (Bounce bounce : Bounce.values()) {
            if (bounce.rows(rows) > 0 && !progress.isCancelled()) {
                int seen = EdgeCoder.place(place, bounce);
                mirrors.visibility.seenFrom(rows, bounce, null, (count, textured, clear) -> level(level + 1));
                reflected += mirrors.visibility.rays();
                if (coded) {
                    coder.shapes(level + 1, seen, levels[level + 1], mirrors.materials);
                }
                Images below = images(level + 1, seen, coded, progress);
                compose(mirrors, level + 1, seen, coded, below, images.of(bounce), progress);
            }
        }
        return images;
    }

    private void compose(Side side, int level, int place, boolean coded, Images images, float[][] to, Progress progress) {
        columns.reset();
        for (int l = 0; l < side.lights.length && !progress.isCancelled(); l++) {
            LightRows layer = side.lights[l].isDark() ? null : side.kernel.full(levels[level], side.lights[l].lamp(), columns);
            layers[l] = layer;
            if (coded && layer != null) {
                coder.light(level, place, l, levels[level], layer, side.materials);
            }
        }
        if (!progress.isCancelled()) {
            side.composer.level(levels[level], side.lights, layers, null, side.world, images, to);
        }
    }

    private HitRows level(int k) {
        if (levels[k] == null) {
            levels[k] = new HitRows(Film.TILE_PIXELS, true, eye.materials.clearCount() > 0 || mirrors.materials.clearCount() > 0,
                    sampling.antialias() == Antialias.EDGES,
                    Luminaire.anyLinked(eye.lights) || Luminaire.anyLinked(mirrors.lights));
        }
        return levels[k];
    }
}
