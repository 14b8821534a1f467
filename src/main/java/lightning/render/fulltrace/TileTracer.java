package lightning.render.fulltrace;

import lightning.base.work.Progress;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeCodeBuilder;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.RayCounts;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.SampleMean;
import lightning.render.shading.ScratchColumns;
import lightning.render.shading.TileComposer;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;

/** Traces tiles one after the other and stores only their pixels. Use one instance per thread and engine. */
final class TileTracer {
    private final SamplingSettings sampling;
    private final int depth;
    private final LevelContext eyeLevel;
    private final LevelContext mirrorLevels;
    private final EdgeCodeBuilder coder = new EdgeCodeBuilder();
    private final ScratchColumns columns = new ScratchColumns();
    private final HitRows[] levels;
    private final LightLayer[] layers;
    private final float[][] samples;
    private long eyeRays;
    private long bounceRays;

    /**
     * Lights of the two scenes of a trace.
     *
     * @param direct   lights of the first level
     * @param mirrored lights of the levels in mirrors
     */
    record SceneLights(WeightedLight[] direct, WeightedLight[] mirrored) {
        static SceneLights of(RenderedScenes scenes) {
            WeightedLight[] lights = WeightedLight.ofScene(scenes.scene());
            return new SceneLights(lights, scenes.mirrored() == scenes.scene() ? lights : WeightedLight.ofScene(scenes.mirrored()));
        }
    }

    /** Data needed for the first level, or for the levels in mirrors. */
    private static final class LevelContext {
        private final WeightedLight[] lights;
        private final Scene scene;
        private final World world;
        private final MaterialTable materials;
        private final TileVisibility visibility;
        private final LightKernel kernel;
        private final TileComposer composer;

        LevelContext(Geometry geometry, Scene scene, WeightedLight[] lights, Engine engine, Tracer tracer) {
            this.lights = lights;
            this.scene = scene;
            world = scene.world();
            materials = geometry.materials();
            visibility = new TileVisibility(geometry, scene, tracer);
            kernel = new LightKernel(geometry, tracer, engine.terms(), ViewEffects.ALL);
            composer = new TileComposer(materials, engine.sums(), ViewEffects.ALL);
        }
    }

    /** @param lights lights of both scenes, shared by all threads and not modified */
    TileTracer(Geometry geometry, Geometry mirroredGeometry, RenderedScenes scenes, SceneLights lights, SamplingSettings sampling,
            Engine engine) {
        this.sampling = sampling;
        depth = scenes.scene().picture().depth();
        Tracer tracer = engine.tracer(geometry);
        eyeLevel = new LevelContext(geometry, scenes.scene(), lights.direct(), engine, tracer);
        mirrorLevels =
                scenes.mirrored() == scenes.scene() ? eyeLevel
                        : new LevelContext(mirroredGeometry, scenes.mirrored(), lights.mirrored(), engine, tracer);
        levels = new HitRows[depth + 1];
        layers = new LightLayer[Math.max(eyeLevel.lights.length, mirrorLevels.lights.length)];
        samples = sampling.isSupersampled() ? new float[3][Film.TILE_PIXELS] : null;
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return new RayCounts(eyeRays, bounceRays,
                eyeLevel.kernel.shadowRays() + (mirrorLevels == eyeLevel ? 0 : mirrorLevels.kernel.shadowRays()));
    }

    /** Traces the centers of a tile's pixels. */
    void traceCenters(Film film, int tile, Progress progress) {
        traceCenters(film, tile, false, progress);
    }

    /** Traces the centers of a tile's pixels; returns their edge codes. */
    EdgeCodes traceCentersWithCodes(Film film, int tile, Progress progress) {
        coder.begin();
        traceCenters(film, tile, true, progress);
        return coder.build();
    }

    private void traceCenters(Film film, int tile, boolean detectEdges, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE_SIZE;
        int y0 = tile / film.tilesX() * Film.TILE_SIZE;
        eyeLevel.visibility.traceEyeRays(x0, y0, Film.TILE_SIZE, (count, textured, clear) -> levelRows(0));
        eyeRays += (long) Math.min(Film.TILE_SIZE, film.width() - x0) * Math.min(Film.TILE_SIZE, film.height() - y0);
        composeTile(SamplePositions.centers(x0, y0), detectEdges, new float[][] {film.red(tile), film.green(tile), film.blue(tile)},
                progress);
    }

    /** Traces all samples of some pixels of a tile; {@code pixels} are ascending indices in the tile. */
    void traceSamples(Film film, int tile, short[] pixels, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE_SIZE;
        int y0 = tile / film.tilesX() * Film.TILE_SIZE;
        float[][] pixel = {film.red(tile), film.green(tile), film.blue(tile)};
        int batchSize = SampleMean.pixelsPerBatch(sampling.samplesPerPixel());
        for (int from = 0; from < pixels.length && !progress.isCanceled(); from += batchSize) {
            int to = Math.min(pixels.length, from + batchSize);
            var places = new SamplePositions(x0, y0, pixels, from, to, sampling.grid());
            eyeLevel.visibility.traceSamples(places, (count, textured, clear) -> levelRows(0));
            eyeRays += (long) (to - from) * sampling.samplesPerPixel();
            composeTile(places, false, samples, progress);
            SampleMean.write(pixels, from, to, sampling.samplesPerPixel(), samples, pixel);
        }
    }

    /** Composes the colors of the first level's rows. */
    private void composeTile(SamplePositions places, boolean detectEdges, float[][] colors, Progress progress) {
        if (detectEdges) {
            coder.addShapes(0, 0, levels[0], eyeLevel.materials);
        }
        BounceImages images = traceImages(0, 0, detectEdges, progress);
        eyeLevel.composer.fillBackground(levels[0], eyeLevel.scene, places, colors);
        compose(eyeLevel, 0, 0, detectEdges, images, colors, progress);
    }

    /** Traces the rays that bounce from the rows of a level; returns their colors. */
    private BounceImages traceImages(int level, int nodeIndex, boolean detectEdges, Progress progress) {
        HitRows rows = levels[level];
        if (level == depth || rows.reflectiveCount == 0) {
            return mirrorLevels.composer.blackImages(rows, level);
        }
        BounceImages images = mirrorLevels.composer.backgroundImages(rows, mirrorLevels.world, level);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0 && !progress.isCanceled()) {
                int childIndex = EdgeCodeBuilder.childIndex(nodeIndex, bounce);
                mirrorLevels.visibility.traceBounceRays(rows, bounce, null, (count, textured, clear) -> levelRows(level + 1));
                bounceRays += mirrorLevels.visibility.rayCount();
                if (detectEdges) {
                    coder.addShapes(level + 1, childIndex, levels[level + 1], mirrorLevels.materials);
                }
                BounceImages below = traceImages(level + 1, childIndex, detectEdges, progress);
                compose(mirrorLevels, level + 1, childIndex, detectEdges, below, images.forBounce(bounce), progress);
            }
        }
        return images;
    }

    private void compose(LevelContext side, int level, int nodeIndex, boolean detectEdges, BounceImages images, float[][] to,
            Progress progress) {
        columns.reset();
        for (int l = 0; l < side.lights.length && !progress.isCanceled(); l++) {
            LightRows layer = side.lights[l].isDark() ? null : side.kernel.recompute(levels[level], side.lights[l].source(), columns);
            layers[l] = layer;
            if (detectEdges && layer != null) {
                coder.addLight(level, nodeIndex, l, levels[level], layer, side.materials);
            }
        }
        if (!progress.isCanceled()) {
            side.composer.composeLevel(levels[level], side.lights, layers, null, side.world, images, to);
        }
    }

    private HitRows levelRows(int k) {
        if (levels[k] == null) {
            levels[k] = new HitRows(Film.TILE_PIXELS, true,
                    eyeLevel.materials.transparentCount() > 0 || mirrorLevels.materials.transparentCount() > 0,
                    sampling.antialias() == AntialiasMode.EDGES,
                    WeightedLight.hasLinked(eyeLevel.lights) || WeightedLight.hasLinked(mirrorLevels.lights));
        }
        return levels[k];
    }
}
