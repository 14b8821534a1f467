package lightning.render.fulltrace;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.BiConsumer;
import lightning.base.work.Progress;
import lightning.render.engine.Engine;
import lightning.render.gather.RowWeigher;
import lightning.render.gather.RowWeights;
import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.RayCounts;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.SampleMean;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.EdgeDetector;
import lightning.render.shading.composition.TileComposer;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.fog.BounceStart;
import lightning.render.shading.fog.FogComposer;
import lightning.render.shading.fog.FogLookup;
import lightning.render.shading.fog.PictureFog;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.BounceKind;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SampleCells;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Traces tiles one after the other and stores only their pixels. Use one instance per thread and engine. */
final class TileTracer {
    private final SamplingSettings sampling;
    private final int depth;
    private final LevelContext eyeLevel;
    private final LevelContext mirrorLevels;
    /** Null if the air is clear, as the next one. */
    private final @Nullable FogLookup fogLookup;
    private final @Nullable BounceFog bounceFog;
    private final FogComposer fogComposer = new FogComposer();
    private final ScratchColumns columns = new ScratchColumns();
    /** Rows of each level, of pixel centers and of finer samples; allocated on first use. */
    private final HitRows[] centerLevels;
    private final HitRows[] sampleLevels;
    /** Those of the current rays. */
    private HitRows[] levels = {};
    private final LightLayer[] layers;
    private final float @Nullable [][] samples;
    /** Colors by which edges are detected; null without edge detection. */
    private final float @Nullable [][] edgeColors;
    private final SampleCells firstCells;
    private final SampleCells restCells;
    private long eyeRays;
    private long bounceRays;

    /**
     * Lights of the two scenes of a trace.
     *
     * @param direct           lights of the first level
     * @param mirrored         lights of the levels in mirrors
     * @param indirect         indirect light of the first level; null if the scene has none
     * @param mirroredIndirect indirect light of the levels in mirrors; null if their scene has none
     * @param fog              fog before the first level; null if the air is clear
     * @param bounceFog        fog along bounced rays; null if no light is seen there
     */
    record SceneLights(WeightedLight[] direct, WeightedLight[] mirrored, @Nullable IndirectLight indirect,
            @Nullable IndirectLight mirroredIndirect, @Nullable PictureFog fog, @Nullable PictureFog bounceFog) {
        static SceneLights of(RenderedScenes scenes) {
            WeightedLight[] lights = WeightedLight.ofScene(scenes.scene());
            return new SceneLights(lights, scenes.mirrored() == scenes.scene() ? lights : WeightedLight.ofScene(scenes.mirrored()), null,
                    null, null, null);
        }

        SceneLights withIndirect(@Nullable IndirectLight light, @Nullable IndirectLight inMirrors) {
            return new SceneLights(direct, mirrored, light, inMirrors, fog, bounceFog);
        }

        SceneLights withFog(@Nullable PictureFog v, @Nullable PictureFog bounced) {
            return new SceneLights(direct, mirrored, indirect, mirroredIndirect, v, bounced);
        }
    }

    /** Data needed for the first level, or for the levels in mirrors. */
    private static final class LevelContext {
        private final WeightedLight[] lights;
        private final WeightedLight[] edgeLights;
        private final Scene scene;
        private final World world;
        private final MaterialTable materials;
        private final TileVisibility visibility;
        private final LightKernel kernel;
        private final TileComposer composer;
        /** Composes the colors by which edges are detected. */
        private final TileComposer edgeComposer;
        /** Null if the scene has no indirect light, as the weigher. */
        private final @Nullable IndirectLight indirect;
        private final @Nullable RowWeigher weigher;

        LevelContext(Geometry geometry, Scene scene, WeightedLight[] lights, @Nullable IndirectLight indirect, Engine engine,
                Tracer tracer) {
            this.lights = lights;
            this.indirect = indirect;
            weigher = indirect == null ? null : new RowWeigher(indirect.structure());
            edgeLights = WeightedLight.forEdges(lights);
            this.scene = scene;
            world = scene.world();
            materials = geometry.materials();
            visibility = new TileVisibility(geometry, scene, tracer);
            kernel = new LightKernel(geometry, tracer, engine.terms(), ViewEffects.ALL);
            composer = new TileComposer(scene, materials, engine.sums(), ViewEffects.ALL);
            edgeComposer = new TileComposer(scene, materials, engine.sums(), ViewEffects.ALL);
        }
    }

    /**
     * Colors of the rays that bounce from the rows of a level.
     *
     * @param edges the same as edge detection sees them; null without edge detection
     */
    private record BouncedColors(@Nullable BounceImages colors, @Nullable BounceImages edges) {}

    /** @param lights lights of both scenes, shared by all threads and not modified */
    TileTracer(Geometry geometry, Geometry mirroredGeometry, RenderedScenes scenes, SceneLights lights, SamplingSettings sampling,
            Engine engine) {
        this.sampling = sampling;
        depth = scenes.scene().picture().depth();
        Tracer tracer = engine.tracer(geometry);
        eyeLevel = new LevelContext(geometry, scenes.scene(), lights.direct(), lights.indirect(), engine, tracer);
        mirrorLevels =
                scenes.mirrored() == scenes.scene() ? eyeLevel
                        : new LevelContext(mirroredGeometry, scenes.mirrored(), lights.mirrored(), lights.mirroredIndirect(), engine,
                                tracer);
        fogLookup = lights.fog() == null ? null : new FogLookup(lights.fog(), lights.direct());
        bounceFog = BounceFog.of(scenes.mirrored(), lights.bounceFog());
        centerLevels = new HitRows[depth + 1];
        sampleLevels = new HitRows[depth + 1];
        layers = new LightLayer[Math.max(eyeLevel.lights.length, mirrorLevels.lights.length)];
        samples = sampling.isSupersampled() ? new float[3][Film.TILE_PIXELS] : null;
        edgeColors = sampling.antialias() == AntialiasMode.EDGES ? new float[3][Film.TILE_PIXELS] : null;
        firstCells = SampleCells.first(sampling);
        restCells = SampleCells.rest(sampling);
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        return new RayCounts(eyeRays, bounceRays, 0,
                eyeLevel.kernel.shadowRays() + (mirrorLevels == eyeLevel ? 0 : mirrorLevels.kernel.shadowRays()));
    }

    /** Traces the centers of a tile's pixels. */
    void traceCenters(Film film, int tile, Progress progress) {
        traceCenters(film, tile, false, progress);
    }

    /** Traces the centers of a tile's pixels; returns the colors by which edges are detected. */
    EdgeColors traceCentersWithEdges(Film film, int tile, Progress progress) {
        traceCenters(film, tile, true, progress);
        return new EdgeColors(EdgeColors.pack(requireNonNull(edgeColors)), null);
    }

    private void traceCenters(Film film, int tile, boolean detectEdges, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE_SIZE;
        int y0 = tile / film.tilesX() * Film.TILE_SIZE;
        levels = centerLevels;
        eyeLevel.visibility.traceEyeRays(x0, y0, Film.TILE_SIZE, (count, textured, clear) -> levelRows(0));
        eyeRays += (long) Math.min(Film.TILE_SIZE, film.width() - x0) * Math.min(Film.TILE_SIZE, film.height() - y0);
        composeTile(SamplePositions.centers(x0, y0), detectEdges, tileColors(film, tile), progress);
    }

    private static float[][] tileColors(Film film, int tile) {
        return new float[][] {film.red(tile), film.green(tile), film.blue(tile)};
    }

    /** Traces the samples of some pixels of a tile; {@code pixels} are ascending indices in the tile. */
    void traceSamples(Film film, int tile, short[] pixels, Progress progress) {
        boolean refines = restCells.count() > 0;
        BitSet refined = new BitSet();
        forEachBatch(film, tile, pixels, firstCells, refines, (batch, colors) -> {
            float[][] pixel = tileColors(film, tile);
            float[][] means = SampleMean.ofPixels(batch.length, firstCells.count(), colors);
            int[] packed = refines ? EdgeColors.pack(requireNonNull(edgeColors)) : null;
            for (int i = 0; i < batch.length; i++) {
                for (int c = 0; c < 3; c++) {
                    pixel[c][batch[i]] = means[c][i];
                }
                refined.set(batch[i], packed != null && EdgeColors.needMore(packed, i * firstCells.count(), firstCells.count()));
            }
        }, progress);
        forEachBatch(film, tile, EdgeDetector.toPixels(refined), restCells, false, (batch, colors) -> {
            float[][] pixel = tileColors(film, tile);
            float[][] means = SampleMean.ofPixels(batch.length, restCells.count(), colors);
            for (int i = 0; i < batch.length; i++) {
                for (int c = 0; c < 3; c++) {
                    pixel[c][batch[i]] =
                            SampleMean.combine(pixel[c][batch[i]], firstCells.count(), means[c][i], restCells.count());
                }
            }
        }, progress);
    }

    /** Traces samples of pixels in batches; the consumer receives the pixels of each batch and the colors of their samples. */
    private void forEachBatch(Film film, int tile, short[] pixels, SampleCells cells, boolean detectEdges,
            BiConsumer<short[], float[][]> consumer, Progress progress) {
        int batchSize = pixels.length == 0 ? 0 : SampleMean.pixelsPerBatch(cells.count());
        levels = sampleLevels;
        float[][] colors = requireNonNull(samples);
        for (int from = 0; from < pixels.length && !progress.isCanceled(); from += batchSize) {
            short[] batch = Arrays.copyOfRange(pixels, from, Math.min(pixels.length, from + batchSize));
            var places = new SamplePositions(tile % film.tilesX() * Film.TILE_SIZE, tile / film.tilesX() * Film.TILE_SIZE, batch, cells);
            eyeLevel.visibility.traceSamples(places, (count, textured, clear) -> levelRows(0));
            eyeRays += places.count();
            composeTile(places, detectEdges, colors, progress);
            consumer.accept(batch, colors);
        }
    }

    /** Composes the colors of the first level's rows. */
    private void composeTile(SamplePositions places, boolean detectEdges, float[][] colors, Progress progress) {
        BouncedColors images = traceImages(0, bounceFog == null ? null : bounceFog.start(places, levels[0]), detectEdges, progress);
        eyeLevel.composer.fillBackground(levels[0], eyeLevel.scene, places, colors);
        if (detectEdges) {
            eyeLevel.edgeComposer.fillBackground(levels[0], eyeLevel.scene, places, requireNonNull(edgeColors));
        }
        compose(eyeLevel, 0, images, colors, detectEdges ? edgeColors : null, progress);
        if (fogLookup != null) {
            fogComposer.add(fogLookup.tile(places, levels[0], null), eyeLevel.lights, eyeLevel.world.fog(), colors);
        }
    }

    /**
     * Traces the rays that bounce from the rows of a level; returns their colors.
     *
     * @param start the rows as the start of bounced rays; null if these show no light in fog
     */
    private BouncedColors traceImages(int level, @Nullable BounceStart start, boolean detectEdges, Progress progress) {
        HitRows rows = levels[level];
        if (level == depth || rows.reflectiveCount == 0) {
            return new BouncedColors(mirrorLevels.composer.blackImages(rows),
                    detectEdges ? mirrorLevels.edgeComposer.blackImages(rows) : null);
        }
        BounceImages images = mirrorLevels.composer.backgroundImages(rows, mirrorLevels.world, level);
        BounceImages edges = detectEdges ? mirrorLevels.edgeComposer.backgroundImages(rows, mirrorLevels.world, level) : null;
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0 && !progress.isCanceled()) {
                mirrorLevels.visibility.traceBounceRays(rows, bounce, null, (count, textured, clear) -> levelRows(level + 1));
                bounceRays += mirrorLevels.visibility.rayCount();
                BouncedColors below =
                        traceImages(level + 1, start == null ? null : start.below(bounce, levels[level + 1]), detectEdges, progress);
                assert images != null;
                compose(mirrorLevels, level + 1, below, images.forBounce(bounce), edges != null ? edges.forBounce(bounce) : null, progress);
                if (bounceFog != null) {
                    bounceFog.add(rows, levels[level + 1], bounce, mirrorLevels.materials,
                            bounceFog.columns(rows, levels[level + 1], bounce, mirrorLevels.materials, start, mirrorLevels.lights, null),
                            mirrorLevels.lights, images.forBounce(bounce));
                }
            }
        }
        return new BouncedColors(images, edges);
    }

    /** @param edgeTo receives the colors by which edges are detected; null without edge detection */
    private void compose(LevelContext side, int level, BouncedColors images, float[][] to, float @Nullable [][] edgeTo, Progress progress) {
        columns.reset();
        for (int l = 0; l < side.lights.length && !progress.isCanceled(); l++) {
            layers[l] = side.lights[l].isDark() ? null : side.kernel.recompute(levels[level], side.lights[l].source(), columns);
        }
        if (!progress.isCanceled()) {
            RowWeights weights = side.weigher == null ? null : side.weigher.weigh(levels[level]);
            side.composer.composeLevel(levels[level], side.lights, layers, side.world,
                    weights == null || side.indirect == null ? null : new IndirectRows(weights, side.indirect.light()), images.colors(),
                    to);
            if (edgeTo != null) {
                side.edgeComposer.composeLevel(levels[level], side.edgeLights, layers, side.world,
                        weights == null || side.indirect == null ? null
                                : new IndirectRows(weights, requireNonNull(side.indirect.edgeLight())),
                        images.edges(), edgeTo);
            }
        }
    }

    private HitRows levelRows(int k) {
        if (levels[k] == null) {
            levels[k] = new HitRows(Film.TILE_PIXELS,
                    eyeLevel.materials.anyTexels().or(mirrorLevels.materials.anyTexels()),
                    eyeLevel.materials.clearCount() > 0 || mirrorLevels.materials.clearCount() > 0,
                    levels == sampleLevels,
                    WeightedLight.needOwners(eyeLevel.lights) || WeightedLight.needOwners(mirrorLevels.lights));
        }
        return levels[k];
    }
}
