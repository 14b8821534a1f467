package lightning.relight;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.cache.CachedTile;
import lightning.cache.FineTile;
import lightning.cache.LayerStamp;
import lightning.cache.PixelCache;
import lightning.cache.TileLevel;
import lightning.relight.plan.LayerPlan;
import lightning.relight.plan.LevelPlan;
import lightning.relight.plan.LightUpdate;
import lightning.relight.plan.MaterialUpdate;
import lightning.relight.plan.UpdatePlan;
import lightning.relight.tile.LayerUpdater;
import lightning.relight.tile.Options;
import lightning.relight.tile.Tally;
import lightning.relight.tile.TilePainter;
import lightning.scene.Scene;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.RatioKernel;
import lightning.shading.TraceCounts;
import lightning.trace.Geometry;
import lightning.trace.MaterialTable;
import lightning.trace.PacketTracer;
import lightning.work.Progress;
import lightning.work.Workers;

/**
 * Brings what is known of a picture from one level of accuracy to another. Both keep each row's state, so that the terms
 * of one follow from the other's without a ray: contributions by multiplying the terms, terms by computing those of lit
 * rows anew. The picture is then composed anew, so that no error of scaled contributions stays in it.
 *
 * @param cache what is known; mirror levels must be kept as rows
 * @param to    how it shall be known
 */
record Conversion(PixelCache cache, Options to) {

    /** Whether a picture can be converted: not where mirror levels are kept as hit shapes, whose rows are gone. */
    static boolean serves(PixelCache cache) {
        return cache.all().stream().allMatch(tile -> tile.hitShapes.length == 0);
    }

    /** What it does, as a plan. */
    UpdatePlan plan() {
        int depth = cache.scene().picture().depth();
        MaterialTable materials = cache.geometry().materials();
        return new UpdatePlan.Relight(level(cache.scene(), cache.stamps(), materials),
                level(cache.mirroredScene(), cache.mirroredStamps(), materials), depth, depth);
    }

    private static LevelPlan level(Scene scene, LayerStamp[] stamps, MaterialTable materials) {
        List<LayerPlan> layers = new ArrayList<>();
        for (int l = 0; l < stamps.length; l++) {
            LightUpdate update = stamps[l] == null ? new LightUpdate.Keep() : new LightUpdate.Refresh();
            layers.add(new LayerPlan(scene.lights().get(l), l, stamps[l], update));
        }
        return new LevelPlan(layers, List.of(), true, MaterialUpdate.none(materials));
    }

    /** What is known afterwards, and what that took. */
    record Result(PixelCache cache, Tally work) {}

    /** @throws CancellationException if {@code progress} asked to stop */
    Result run(Workers workers, Progress progress) {
        var top = Lit.of(cache.scene(), cache.stamps());
        var mirrors = Lit.of(cache.mirroredScene(), cache.mirroredStamps());
        Tiles[] threads = new Tiles[workers.count()];
        Arrays.setAll(threads, _ -> new Tiles(cache, to));
        CachedTile[] tiles = new CachedTile[cache.tileCount()];
        FineTile[] fine = new FineTile[cache.fineCount()];
        int perPixel = cache.scene().picture().sampling().perPixel();
        workers.run(Math.max(tiles.length, fine.length), (worker, i) -> {
            CachedTile center = tiles.length == 0 ? null : threads[worker].convert(cache.tile(i), top, mirrors);
            if (center != null) {
                tiles[i] = center;
            }
            if (fine.length > 0) {
                fine[i] = cache.fine(i).map(center, block -> threads[worker].convert(block, top, mirrors), perPixel);
            }
        }, progress);
        Tally work = Tally.NONE;
        for (Tiles thread : threads) {
            work = work.plus(thread.work());
        }
        return new Result(new PixelCache(cache.geometry(), tiles, fine, cache.sight(), fresh(cache.stamps()),
                fresh(cache.mirroredStamps())), work);
    }

    private static LayerStamp[] fresh(LayerStamp[] stamps) {
        return Arrays.stream(stamps).map(s -> s == null ? null : LayerStamp.fresh(s.light())).toArray(LayerStamp[]::new);
    }

    /**
     * The lights of some levels.
     *
     * @param scene    what the levels show
     * @param shining  its lights
     * @param computed the light that each layer was computed for, which may be older where the light does not shine; null
     *                 where there is no layer
     */
    private record Lit(Scene scene, Lamp[] shining, Lamp[] computed) {
        static Lit of(Scene scene, LayerStamp[] stamps) {
            return new Lit(scene, Lamp.all(scene), Arrays.stream(stamps)
                    .map(s -> s == null ? null : Lamp.shining(s.light(), scene)).toArray(Lamp[]::new));
        }
    }

    /** Converts layers, with scratch memory: one for each thread and each of the first level and those in mirrors. */
    private static final class Layers {
        private final LightKernel lights;
        private final RatioKernel ratios;
        private final LayerUpdater updater;

        Layers(Geometry geometry, Options to) {
            lights = new LightKernel(geometry, new PacketTracer(geometry), to.view());
            ratios = new RatioKernel(lights);
            updater = LayerUpdater.of(to.accuracy(), lights, ratios);
        }

        TileLevel convert(TileLevel old, Lit lit) {
            LightLayer[] layers = new LightLayer[old.layers().length];
            for (int l = 0; l < layers.length; l++) {
                LightLayer before = old.layers()[l];
                layers[l] = before == null ? null : updater.convert(old.rows(), lit.computed()[l], before);
            }
            return new TileLevel(old.rows(), layers);
        }

        Tally work(long rowsComposed) {
            return new Tally(lights.rowsTouched() + ratios.rowsScaled(), rowsComposed, 0, new TraceCounts(0, 0, lights.shadowRays()));
        }
    }

    /** Converts tiles: one for each thread. */
    private static final class Tiles {
        private final Layers eye;
        private final Layers mirror;
        private final TilePainter painter;
        private long rowsComposed;

        Tiles(PixelCache cache, Options to) {
            eye = new Layers(cache.geometry(), to);
            mirror = new Layers(cache.geometry().of(cache.mirroredScene()), to);
            painter = new TilePainter(cache, to.view());
        }

        CachedTile convert(CachedTile old, Lit top, Lit mirrors) {
            TileLevel[] levels = new TileLevel[old.levels.length];
            for (int k = 0; k < levels.length; k++) {
                levels[k] = k == 0 ? eye.convert(old.levels[k], top) : mirror.convert(old.levels[k], mirrors);
                rowsComposed += levels[k].rows().count;
            }
            float[][] scratch = painter.mirrored(levels, mirrors.shining(), mirrors.scene().world());
            float[][] cr = scratch == null ? null : copyOf(scratch, levels[0].rows().reflective);
            return new CachedTile(levels, old.hitShapes, cr, painter.film(levels[0], top.shining(), top.scene().world(), cr),
                    old.codes);
        }

        private static float[][] copyOf(float[][] columns, int rows) {
            return new float[][] {Arrays.copyOf(columns[0], rows), Arrays.copyOf(columns[1], rows), Arrays.copyOf(columns[2], rows)};
        }

        Tally work() {
            return eye.work(rowsComposed).plus(mirror.work(0));
        }
    }
}
