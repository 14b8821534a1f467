package lightning.render.relight;

import static java.util.Objects.requireNonNull;

import java.util.BitSet;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.CachedLight;
import lightning.render.cache.CachedScene;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.cache.SampleBlock;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.engine.EngineWorkers;
import lightning.render.image.Film;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.TileRecomposer;
import lightning.render.relight.tile.WorkCounts;
import lightning.render.shading.BounceImages;
import lightning.render.shading.FilmParts;
import lightning.render.shading.RayCounts;
import lightning.render.shading.StoredFilms;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.FilmColors;
import lightning.render.shading.composition.FilmMixer;
import lightning.render.shading.fog.BounceFog;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SampleCells;
import lightning.render.trace.SamplePositions;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Converts a pixel cache from one accuracy to the other without casting rays. Both accuracies store each row's state: contributions
 * are computed by multiplying the terms, and terms by recomputing lit rows. The picture is then recomposed, so that no error of
 * scaled contributions remains.
 *
 * @param cache   the cache to convert; its mirror levels must be stored as rows
 * @param options target options
 */
record CacheConversion(PixelCache cache, RenderOptions options) {

    /** Returns whether a cache can be converted: neither mirror levels stored as hit shapes, which have no rows, nor gathered light. */
    static boolean canConvert(PixelCache cache) {
        return cache.indirect() == null && cache.mirrored().indirect() == null
                && cache.allTiles().stream().allMatch(CachedTile::storesRows);
    }

    /** Returns the conversion as a plan. */
    UpdatePlan plan() {
        int depth = cache.scene().picture().depth();
        MaterialTable materials = cache.geometry().materials();
        return new UpdatePlan.Relight(LevelPlan.refresh(cache.shown(), materials, light -> light.stamp() != null),
                LevelPlan.refresh(cache.mirrored(), materials, light -> light.stamp() != null), depth, depth,
                PathUpdate.unchanged(cache));
    }

    /** Converted cache and the work it took. */
    record Result(PixelCache cache, WorkCounts work) {}

    /** @throws CancellationException if {@code progress} requested cancellation */
    Result run(WorkerPool workers, Progress progress) {
        var top = LevelLights.of(cache.shown());
        var mirrors = LevelLights.of(cache.mirrored());
        List<EngineWorkers<TileConverter>> threads =
                EngineWorkers.perThread(workers.count(), options.engines(), engine -> new TileConverter(cache, options, engine));
        CachedTile[] tiles = new CachedTile[cache.tileCount()];
        FineTile[] fine = new FineTile[cache.fineCount()];
        int tilesX = Film.tilesAlong(cache.scene().picture().width());
        workers.run(Math.max(tiles.length, fine.length), (worker, i) -> {
            TileConverter converter = threads.get(worker).forTile(i);
            SamplePositions centers = SamplePositions.centers(i % tilesX * Film.TILE_SIZE, i / tilesX * Film.TILE_SIZE);
            CachedTile center = tiles.length == 0 ? null : converter.convert(centers, cache.tile(i), true, top, mirrors);
            if (center != null) {
                tiles[i] = center;
            }
            if (fine.length > 0) {
                fine[i] = converter.convert(cache.fineTile(i), center, centers, top, mirrors);
            }
        }, progress);
        WorkCounts work = threads.stream().flatMap(thread -> thread.workers().stream()).map(TileConverter::work).reduce(WorkCounts.NONE,
                WorkCounts::plus);
        return new Result(new PixelCache(cache.geometry(), tiles, fine, recomputed(cache.shown()), recomputed(cache.mirrored()),
                !options.method().isExact()), work);
    }

    /** Returns the scene with stamps of layers that were just computed; only scenes without gathered light are converted. */
    private static CachedScene recomputed(CachedScene known) {
        return new CachedScene(known.scene(), known.lights().stream().map(CachedLight::withComputedStamp).toList(), null, known.fog());
    }

    /** Lights of a scene that levels show: as they are cached. */
    private record LevelLights(Scene scene, List<CachedLight> cachedLights) {
        static LevelLights of(CachedScene known) {
            return new LevelLights(known.scene(), known.lights());
        }
    }

    /** Converts layers with scratch memory: one instance for each thread, and for the first level and those in mirrors. */
    private static final class LayerConverter {
        private final LightKernel kernel;
        private final LayerUpdater updater;

        LayerConverter(Geometry geometry, RenderOptions to, Engine engine) {
            kernel = new LightKernel(geometry, engine.tracer(geometry), engine.terms(), to.view());
            updater = to.method().updater(kernel, 0);
        }

        TileLevel convert(TileLevel old, LevelLights lights) {
            return new TileLevel(old.rows(), lights.cachedLights().stream().map(light -> convert(old, light, lights.scene()))
                    .toArray(LightLayer[]::new));
        }

        private @Nullable LightLayer convert(TileLevel old, CachedLight light, Scene scene) {
            LightLayer before = light.layer(old);
            return before == null ? null
                    : updater.convert(old.rows(), withFogOf(requireNonNull(light.stamp()), scene), before);
        }

        private static WeightedLight withFogOf(LayerStamp stamp, Scene scene) {
            return WeightedLight.ofSwitchedOn(stamp.light(), scene).withFog(stamp.fog());
        }

        WorkCounts work(long rowsComposed) {
            return new WorkCounts(updater.rowsTouched(), rowsComposed, 0, RayCounts.ofShadows(kernel.shadowRays()));
        }
    }

    /** Converts tiles: one instance per thread. */
    private static final class TileConverter {
        private final LayerConverter eye;
        private final LayerConverter mirror;
        private final TileRecomposer recomposer;
        private final BitSet shining;
        private final RenderOptions to;
        private final FilmColors films = new FilmColors();

        TileConverter(PixelCache cache, RenderOptions to, Engine engine) {
            this.to = to;
            eye = new LayerConverter(cache.geometry(), to, engine);
            mirror = new LayerConverter(cache.mirroredGeometry(), to, engine);
            var shown = shown(cache.scene(), cache.geometry());
            recomposer = new TileRecomposer(shown,
                    !cache.areMirrorsOutdated() ? shown : shown(cache.mirrored().scene(), cache.mirroredGeometry()), engine, to.view(), -1);
            recomposer.setMirrorFog(BounceFog.of(cache.mirrored().scene(), cache.mirrored().fog()));
            shining = shown.parts().shining();
        }

        private TileRecomposer.Shown shown(Scene scene, Geometry geometry) {
            return new TileRecomposer.Shown(FilmParts.of(scene, !to.method().isExact()), geometry.materials(),
                    null);
        }

        /** Converts a tile, whose films are then in {@link #films}. */
        CachedTile convert(SamplePositions places, CachedTile old, boolean stores, LevelLights top, LevelLights mirrors) {
            TileLevel[] levels = new TileLevel[old.levels().length];
            for (int k = 0; k < levels.length; k++) {
                levels[k] = k == 0 ? eye.convert(old.levels()[k], top) : mirror.convert(old.levels()[k], mirrors);
            }
            boolean areMirrorsCurrent = !recomposer.areMirrorsOutdated();
            FilmColors[] bounced = recomposer.composeImages(places, levels, areMirrorsCurrent ? shining : recomposer.mirrored().shining());
            BounceImages images = bounced == null ? null : recomposer.mixer().images(levels[0].rows(), bounced, false)
                    .compact(levels[0].rows());
            recomposer.composeFilms(levels[0], places, shining, areMirrorsCurrent ? bounced : null, areMirrorsCurrent ? null : images, null,
                    old.fog(), films);
            float[][] colors = new float[3][Film.TILE_PIXELS];
            recomposer.mixer().mix(films::get, colors);
            return new CachedTile(levels, old.hitShapes(), images, stores || !to.method().isExact() ? colors : null, null, old.edges(),
                    old.fog());
        }

        FineTile convert(FineTile tile, @Nullable CachedTile center, SamplePositions centers, LevelLights top, LevelLights mirrors) {
            FineSamples first = tile.first().map(block -> convert(block, centers, tile.first().cells(), top, mirrors));
            FineSamples rest = tile.rest().map(block -> convert(block, centers, tile.rest().cells(), top, mirrors));
            return FineTile.of(center == null ? null : center.film(), first, rest, FineTile.films(first, rest, recomposer.mixer().films()),
                    recomposer.mixer());
        }

        private SampleBlock convert(SampleBlock block, SamplePositions centers, SampleCells cells, LevelLights top, LevelLights mirrors) {
            CachedTile rows = convert(block.positions(centers, cells), block.rows(), false, top, mirrors);
            int count = recomposer.mixer().films();
            BitSet known = (BitSet) shining.clone();
            known.set(count - FilmMixer.EARLIER_FILMS, count);
            return new SampleBlock(block.pixels(), rows, new StoredFilms(films.means(count, block.pixels().length, cells.count()), known));
        }

        WorkCounts work() {
            return eye.work(recomposer.rowsComposed()).plus(mirror.work(0));
        }
    }
}
