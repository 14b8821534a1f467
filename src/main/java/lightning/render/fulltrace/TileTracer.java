package lightning.render.fulltrace;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import lightning.base.work.Progress;
import lightning.render.engine.Engine;
import lightning.render.gather.GatherRays;
import lightning.render.gather.RowWeigher;
import lightning.render.image.Film;
import lightning.render.shading.BounceImages;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.IndirectRows;
import lightning.render.shading.RayCounts;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.SampleMean;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.FilmMeans;
import lightning.render.shading.composition.FilmMixer;
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
    /** Films of the current rays, and of pixels that have several samples. */
    private final FilmColors films = new FilmColors();
    private final FilmMeans means;
    private final FilmMixer mixer;
    private final SampleCells firstCells;
    private final SampleCells restCells;
    private long eyeRays;
    private long bounceRays;

    /**
     * Lights of the two scenes of a trace.
     *
     * @param direct           films of the first level
     * @param mirrored         films of the levels in mirrors
     * @param indirect         indirect light of the first level; null if the scene has none
     * @param mirroredIndirect indirect light of the levels in mirrors; null if their scene has none
     * @param fog              fog before the first level; null if the air is clear
     * @param bounceFog        fog along bounced rays; null if no light is seen there
     */
    record SceneLights(FilmParts direct, FilmParts mirrored, @Nullable IndirectLight indirect,
            @Nullable IndirectLight mirroredIndirect, @Nullable PictureFog fog, @Nullable PictureFog bounceFog) {
        static SceneLights of(RenderedScenes scenes) {
            FilmParts parts = FilmParts.of(scenes.scene());
            return new SceneLights(parts, scenes.areReflectionsCurrent() ? parts : FilmParts.of(scenes.mirrored()), null, null, null, null);
        }

        SceneLights withIndirect(@Nullable IndirectLight light, @Nullable IndirectLight inMirrors) {
            return new SceneLights(direct, mirrored, light, inMirrors, fog, bounceFog);
        }

        SceneLights withFog(@Nullable PictureFog v, @Nullable PictureFog bounced) {
            return new SceneLights(direct, mirrored, indirect, mirroredIndirect, v, bounced);
        }

        /** Returns whether mirrors show an earlier scene. */
        boolean areMirrorsOutdated() {
            return direct != mirrored;
        }
    }

    /** Data needed for the first level, or for the levels in mirrors. */
    private static final class LevelContext {
        private final FilmParts parts;
        /** Films that are not dark. */
        private final BitSet films;
        private final Scene scene;
        private final MaterialTable materials;
        private final TileVisibility visibility;
        private final LightKernel kernel;
        private final TileComposer composer;
        /** Null if the scene has no indirect light, as the weigher. */
        private final @Nullable IndirectLight indirect;
        private final @Nullable RowWeigher weigher;

        LevelContext(Geometry geometry, FilmParts parts, @Nullable IndirectLight indirect, Engine engine, Tracer tracer) {
            this.parts = parts;
            films = parts.shining();
            this.indirect = indirect;
            weigher = indirect == null ? null : new RowWeigher(indirect.structure());
            scene = parts.scene();
            materials = geometry.materials();
            visibility = new TileVisibility(geometry, scene, tracer);
            kernel = new LightKernel(geometry, tracer, engine.terms(), ViewEffects.ALL);
            composer = new TileComposer(scene, materials, engine.sums(), ViewEffects.ALL);
        }
    }

    /** @param lights lights of both scenes, shared by all threads and not modified */
    TileTracer(Geometry geometry, Geometry mirroredGeometry, RenderedScenes scenes, SceneLights lights, SamplingSettings sampling,
            Engine engine) {
        this.sampling = sampling;
        depth = scenes.scene().picture().depth();
        Tracer tracer = engine.tracer(geometry);
        eyeLevel = new LevelContext(geometry, lights.direct(), lights.indirect(), engine, tracer);
        mirrorLevels = !lights.areMirrorsOutdated() ? eyeLevel
                : new LevelContext(mirroredGeometry, lights.mirrored(), lights.mirroredIndirect(), engine, tracer);
        mixer = new FilmMixer(lights.direct(), lights.areMirrorsOutdated() ? lights.mirrored() : null, -1);
        fogLookup = lights.fog() == null ? null : new FogLookup(lights.fog(), lights.direct().lights());
        bounceFog = BounceFog.of(mirrorLevels.scene, lights.bounceFog());
        centerLevels = new HitRows[depth + 1];
        sampleLevels = new HitRows[depth + 1];
        layers = new LightLayer[Math.max(eyeLevel.parts.lights().length, mirrorLevels.parts.lights().length)];
        firstCells = SampleCells.first(scenes.scene());
        restCells = SampleCells.rest(scenes.scene());
        means = new FilmMeans(firstCells.count(), restCells.count());
    }

    /** Returns the rays cast so far. */
    RayCounts rays() {
        RayCounts rays = new RayCounts(eyeRays, bounceRays, GatherRays.NONE, eyeLevel.kernel.shadowRays());
        return mirrorLevels == eyeLevel ? rays : rays.plus(RayCounts.ofShadows(mirrorLevels.kernel.shadowRays()));
    }

    /** Traces the centers of a tile's pixels. */
    void traceCenters(Film film, int tile, Progress progress) {
        int x0 = tile % film.tilesX() * Film.TILE_SIZE;
        int y0 = tile / film.tilesX() * Film.TILE_SIZE;
        levels = centerLevels;
        eyeLevel.visibility.traceEyeRays(x0, y0, Film.TILE_SIZE, (count, textured, clear) -> levelRows(0));
        eyeRays += (long) Math.min(Film.TILE_SIZE, film.width() - x0) * Math.min(Film.TILE_SIZE, film.height() - y0);
        composeTile(SamplePositions.centers(x0, y0), progress);
        mixer.mix(films::get, tileColors(film, tile));
    }

    /** Traces the centers of a tile's pixels; returns the colors by which edges are detected. */
    EdgeColors traceCentersWithEdges(Film film, int tile, Progress progress) {
        traceCenters(film, tile, progress);
        return new EdgeColors(mixer.edgeColors(films::get, Film.TILE_PIXELS), null);
    }

    private static float[][] tileColors(Film film, int tile) {
        return new float[][] {film.red(tile), film.green(tile), film.blue(tile)};
    }

    /** Traces the samples of some pixels of a tile; {@code pixels} are ascending indices in the tile. */
    void traceSamples(Film film, int tile, short[] pixels, Progress progress) {
        boolean refines = restCells.count() > 0;
        means.clear(mixer.films(), pixels.length);
        short[] refined = new short[pixels.length];
        int[] places = new int[pixels.length];
        var count = new int[1];
        forEachBatch(tile, pixels, firstCells, (from, batch) -> {
            means.setFirst(from, batch.length, films);
            int[] packed = refines ? mixer.edgeColors(films::get, batch.length * firstCells.count()) : null;
            for (int i = 0; packed != null && i < batch.length; i++) {
                if (EdgeColors.needMore(packed, i * firstCells.count(), firstCells.count())) {
                    places[count[0]] = from + i;
                    refined[count[0]++] = batch[i];
                }
            }
        }, progress);
        forEachBatch(tile, Arrays.copyOf(refined, count[0]), restCells,
                (from, batch) -> means.addRest(Arrays.copyOfRange(places, from, from + batch.length), films), progress);
        float[][] colors = new float[3][pixels.length];
        mixer.mix(means.films()::get, colors);
        float[][] pixel = tileColors(film, tile);
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < pixels.length; i++) {
                pixel[c][pixels[i]] = colors[c][i];
            }
        }
    }

    /** Receives pixels whose samples are in the films. */
    @FunctionalInterface
    private interface BatchConsumer {
        /** @param from number of pixels in earlier batches */
        void accept(int from, short[] batch);
    }

    /** Traces samples of pixels in batches. */
    private void forEachBatch(int tile, short[] pixels, SampleCells cells, BatchConsumer consumer, Progress progress) {
        int batchSize = pixels.length == 0 ? 0 : SampleMean.pixelsPerBatch(cells.count());
        levels = sampleLevels;
        int tilesX = Film.tilesAlong(eyeLevel.scene.picture().width());
        for (int from = 0; from < pixels.length && !progress.isCanceled(); from += batchSize) {
            short[] batch = Arrays.copyOfRange(pixels, from, Math.min(pixels.length, from + batchSize));
            var places = new SamplePositions(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE, batch, cells);
            eyeLevel.visibility.traceSamples(places, (count, textured, clear) -> levelRows(0));
            eyeRays += places.count();
            composeTile(places, progress);
            consumer.accept(from, batch);
        }
    }

    /** Composes the colors of the first level's rows in all films. */
    private void composeTile(SamplePositions places, Progress progress) {
        FilmColors[] images = traceImages(0, bounceFog == null ? null : bounceFog.start(places, levels[0]), progress);
        eyeLevel.composer.fillBackground(levels[0], eyeLevel.parts, eyeLevel.films, places, films);
        compose(eyeLevel, 0, mirrorLevels == eyeLevel ? images : null, films, progress);
        if (mirrorLevels != eyeLevel && images != null) {
            BounceImages earlier = mixer.images(levels[0], images, false).compact(levels[0]);
            BounceImages edges = sampling.antialias() == AntialiasMode.EDGES ? mixer.images(levels[0], images, true) : null;
            mixer.addEarlierMirrors(levels[0], earlier, edges, eyeLevel.composer, films);
        }
        if (fogLookup != null) {
            fogComposer.add(fogLookup.tile(places, levels[0], null), eyeLevel.parts, eyeLevel.films, eyeLevel.scene.world().fog(), films);
        }
    }

    /**
     * Traces the rays that bounce from the rows of a level; returns their colors, null if they are black.
     *
     * @param start the rows as the start of bounced rays; null if these show no light in fog
     */
    private FilmColors @Nullable [] traceImages(int level, @Nullable BounceStart start, Progress progress) {
        HitRows rows = levels[level];
        if (level == depth || rows.reflectiveCount == 0) {
            return null;
        }
        FilmColors[] images = mirrorLevels.composer.backgrounds(rows, mirrorLevels.parts, mirrorLevels.films, level);
        for (BounceKind bounce : BounceKind.values()) {
            if (bounce.rowCount(rows) > 0 && !progress.isCanceled()) {
                mirrorLevels.visibility.traceBounceRays(rows, bounce, null, (count, textured, clear) -> levelRows(level + 1));
                bounceRays += mirrorLevels.visibility.rayCount();
                FilmColors[] below = traceImages(level + 1, start == null ? null : start.below(bounce, levels[level + 1]), progress);
                FilmColors colors = images[bounce.ordinal()];
                compose(mirrorLevels, level + 1, below, colors, progress);
                if (bounceFog != null) {
                    bounceFog.add(rows, levels[level + 1], bounce, mirrorLevels.materials,
                            bounceFog.columns(rows, levels[level + 1], bounce, mirrorLevels.materials, start, mirrorLevels.parts.lights(),
                                    null),
                            mirrorLevels.parts, mirrorLevels.films, colors);
                }
            }
        }
        return images;
    }

    private void compose(LevelContext side, int level, FilmColors @Nullable [] images, FilmColors to, Progress progress) {
        columns.reset();
        WeightedLight[] lights = side.parts.lights();
        for (int l = 0; l < lights.length && !progress.isCanceled(); l++) {
            layers[l] = lights[l].isDark() ? null : side.kernel.recompute(levels[level], lights[l].source(), columns);
        }
        if (!progress.isCanceled()) {
            IndirectRows indirect = side.weigher == null ? null
                    : new IndirectRows(side.weigher.weigh(levels[level]), requireNonNull(side.indirect).light());
            side.composer.composeLevel(levels[level], side.parts, side.films, layers, indirect, images, to);
        }
    }

    private HitRows levelRows(int k) {
        if (levels[k] == null) {
            levels[k] = new HitRows(Film.TILE_PIXELS,
                    eyeLevel.materials.anyTexels().or(mirrorLevels.materials.anyTexels()),
                    eyeLevel.materials.clearCount() > 0 || mirrorLevels.materials.clearCount() > 0,
                    levels == sampleLevels,
                    WeightedLight.needOwners(eyeLevel.parts.lights()) || WeightedLight.needOwners(mirrorLevels.parts.lights()));
        }
        return levels[k];
    }
}
