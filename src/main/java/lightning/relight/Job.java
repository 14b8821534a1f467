package lightning.relight;

import lightning.cache.TileLevel;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.shading.Columns;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightRows;
import lightning.shading.Progress;
import lightning.trace.Geometry;

/**
 * What all threads of one update share, made ready once.
 *
 * @param scene the scene wanted
 * @param lamps its lights, in its order
 * @param keepsRows whether mirror levels are kept as full rows
 * @param top the update of the first level; null in a first pass
 * @param mirrors the update of the mirror levels; null where they stay, and in a first pass
 */
record Job(Geometry geometry, Scene scene, Lamp[] lamps, boolean keepsRows, Level top, Level mirrors, Progress progress) {

    static Lamp[] lamps(Scene scene) {
        return scene.lights().stream().map(light -> Lamp.of(light, scene)).toArray(Lamp[]::new);
    }

    int depth() {
        return scene.picture().depth();
    }

    int tilesX() {
        return (scene.picture().width() + Film.TILE - 1) / Film.TILE;
    }

    /**
     * A level's plan, with the lights whose effective weight changes: colour, intensity, on or solo.
     */
    record Level(LevelPlan plan, Lamp[] lamps, boolean[] reweighted) {

        static Level of(LevelPlan plan, Scene known, Lamp[] lamps) {
            boolean[] reweighted = new boolean[lamps.length];
            for (int l = 0; l < lamps.length; l++) {
                int from = plan.layers().get(l).from();
                Lamp before = from < 0 ? null : Lamp.of(known.lights().get(from), known);
                reweighted[l] = before == null || before.red() != lamps[l].red()
                        || before.green() != lamps[l].green() || before.blue() != lamps[l].blue();
            }
            return new Level(plan, lamps, reweighted);
        }

        /** The layers over one tile's rows after the update; those not touched are the old ones. */
        LightRows[] layers(TileLevel old, LightKernel kernel, Columns columns, Progress progress) {
            LightRows[] layers = new LightRows[lamps.length];
            for (int l = 0; l < lamps.length && !progress.isCancelled(); l++) {
                LayerPlan layer = plan.layers().get(l);
                LightRows before = layer.from() < 0 ? null : old.layers()[layer.from()];
                layers[l] = switch (layer.update()) {
                    case LightUpdate.Keep _ -> before;
                    case LightUpdate.Reweight _ -> before;
                    case LightUpdate.FullRecompute _ -> kernel.full(old.rows(), lamps[l], columns);
                    case LightUpdate.Partial p ->
                        kernel.partial(old.rows(), lamps[l], before, p.cone(), p.falloff(), columns);
                };
            }
            return layers;
        }

        /** Whether any row's colour may differ from before, its mirror image left out. */
        boolean recolors(TileLevel old, LightRows[] layers) {
            if (plan.compose()) {
                return true;
            }
            for (int l = 0; l < lamps.length; l++) {
                int from = plan.layers().get(l).from();
                LightRows before = from < 0 ? null : old.layers()[from];
                boolean shone = before != null && before.lit > 0;
                boolean shines = layers[l] != null && layers[l].lit > 0;
                if ((before != layers[l] || reweighted[l]) && (shone || shines)) {
                    return true;
                }
            }
            return false;
        }
    }
}
