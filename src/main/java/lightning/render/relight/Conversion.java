package lightning.render.relight;

import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.cache.KnownLight;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Crew;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.render.relight.tile.Tally;
import lightning.render.relight.tile.TilePainter;
import lightning.render.shading.Images;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePlaces;
import lightning.scene.Scene;

/**
 * Brings what is known of a picture from one accuracy to the other. Both keep each row's state, so that the terms
 * of one follow from the other's without a ray: contributions by multiplying the terms, terms by computing those of lit
 * rows anew. The picture is then composed anew, so that no error of scaled contributions stays in it.
 *
 * @param cache what is known; mirror levels must be kept as rows
 * @param to    how it shall be known
 */
record Conversion(PixelCache cache, Options to) {

    /** Whether a picture can be converted: not where mirror levels are kept as hit shapes, whose rows are gone. */
    static boolean serves(PixelCache cache) {
        return cache.all().stream().allMatch(CachedTile::keepsRows);
    }

    /** What it does, as a plan. */
    UpdatePlan plan() {
        int depth = cache.scene().picture().depth();
        MaterialTable materials = cache.geometry().materials();
        return new UpdatePlan.Relight(LevelPlan.refresh(cache.scene(), cache.lights(), materials, light -> light.stamp() != null),
                LevelPlan.refresh(cache.mirroredScene(), cache.mirroredLights(), materials, light -> light.stamp() != null), depth, depth);
    }

    /** What is known afterwards, and what that took. */
    record Result(PixelCache cache, Tally work) {}

    /** @throws CancellationException if {@code progress} asked to stop */
    Result run(Workers workers, Progress progress) {
        var top = Lights.of(cache.scene(), cache.lights());
        var mirrors = Lights.of(cache.mirroredScene(), cache.mirroredLights());
        List<Crew<Tiles>> threads = Crew.each(workers.count(), to.engines(), engine -> new Tiles(cache, to, engine));
        CachedTile[] tiles = new CachedTile[cache.tileCount()];
        FineTile[] fine = new FineTile[cache.fineCount()];
        int grid = cache.scene().picture().sampling().grid();
        int tilesX = Film.tilesAlong(cache.scene().picture().width());
        workers.run(Math.max(tiles.length, fine.length), (worker, i) -> {
            SamplePlaces centers = SamplePlaces.centers(i % tilesX * Film.TILE, i / tilesX * Film.TILE);
            CachedTile center = tiles.length == 0 ? null : threads.get(worker).forTile(i).convert(centers, cache.tile(i), top, mirrors);
            if (center != null) {
                tiles[i] = center;
            }
            if (fine.length > 0) {
                FineTile tile = cache.fine(i).map(center, centers,
                        (places, block) -> threads.get(worker).forTile(i).convert(places, block, top, mirrors), grid);
                fine[i] = to.accuracy().isExact() ? tile.withoutColors() : tile;
            }
        }, progress);
        Tally work = threads.stream().flatMap(crew -> crew.all().stream()).map(Tiles::work).reduce(Tally.NONE, Tally::plus);
        return new Result(new PixelCache(cache.geometry(), tiles, fine, cache.scenes(), recomputed(cache.lights()),
                recomputed(cache.mirroredLights())), work);
    }

    private static List<KnownLight> recomputed(List<KnownLight> lights) {
        return lights.stream().map(KnownLight::recomputed).toList();
    }

    /** The lights of a scene that levels show, as they shine, and as they are known. */
    private record Lights(Scene scene, Luminaire[] shining, List<KnownLight> known) {
        static Lights of(Scene scene, List<KnownLight> known) {
            return new Lights(scene, Luminaire.all(scene), known);
        }
    }

    /** Converts layers, with scratch memory: one for each thread and each of the first level and those in mirrors. */
    private static final class Layers {
        private final LightKernel kernel;
        private final LayerUpdater updater;

        Layers(Geometry geometry, Options to, Engine engine) {
            kernel = new LightKernel(geometry, engine.tracer(geometry), engine.terms(), to.view());
            updater = to.method().updater(kernel, 0);
        }

        TileLevel convert(TileLevel old, Lights lights) {
            return new TileLevel(old.rows(), lights.known().stream().map(light -> convert(old, light, lights.scene()))
                    .toArray(LightLayer[]::new));
        }

        private LightLayer convert(TileLevel old, KnownLight light, Scene scene) {
            LightLayer before = light.layer(old);
            return before == null ? null : updater.convert(old.rows(), Luminaire.shining(light.stamp().light(), scene), before);
        }

        Tally work(long rowsComposed) {
            return new Tally(updater.rowsTouched(), rowsComposed, 0, new TraceCounts(0, 0, kernel.shadowRays()));
        }
    }

    /** Converts tiles: one for each thread. */
    private static final class Tiles {
        private final Layers eye;
        private final Layers mirror;
        private final TilePainter painter;
        private long rowsComposed;

        Tiles(PixelCache cache, Options to, Engine engine) {
            eye = new Layers(cache.geometry(), to, engine);
            mirror = new Layers(cache.geometry().of(cache.mirroredScene()), to, engine);
            painter = new TilePainter(cache, engine, to.view());
        }

        CachedTile convert(SamplePlaces places, CachedTile old, Lights top, Lights mirrors) {
            TileLevel[] levels = new TileLevel[old.levels.length];
            for (int k = 0; k < levels.length; k++) {
                levels[k] = k == 0 ? eye.convert(old.levels[k], top) : mirror.convert(old.levels[k], mirrors);
                rowsComposed += levels[k].rows().count;
            }
            Images scratch = painter.images(levels, mirrors.shining(), mirrors.scene().world());
            Images images = scratch == null ? null : scratch.compact(levels[0].rows());
            return new CachedTile(levels, old.hitShapes, images, painter.film(levels[0], top.shining(), top.scene(), places, images),
                    old.codes);
        }

        Tally work() {
            return eye.work(rowsComposed).plus(mirror.work(0));
        }
    }
}
