package lightning.relight.tile;

import lightning.cache.LayerStamp;
import lightning.cache.TileLevel;
import lightning.image.Film;
import lightning.relight.plan.LayerPlan;
import lightning.relight.plan.LevelPlan;
import lightning.relight.plan.LightUpdate;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.shading.BranchSums;
import lightning.shading.ConeChange;
import lightning.shading.Lamp;
import lightning.shading.LightLayer;
import lightning.trace.Geometry;
import lightning.work.Progress;

/**
 * What all threads of one update share, made ready once.
 *
 * @param shown    what the first level shall show
 * @param mirrored what the mirror levels shall show: the same where they are updated too, and in a first pass
 * @param top      the update of the first level; null in a first pass
 * @param mirrors  the update of the mirror levels; null where they stay, and in a first pass
 * @param coding   whether anti-aliasing looks for edges
 */
public record Job(Shown shown, Shown mirrored, Options options, Level top, Level mirrors, boolean coding, Progress progress) {

    /**
     * What levels show.
     *
     * @param geometry with the scene's materials
     * @param lamps    the scene's lights, in its order
     */
    public record Shown(Geometry geometry, Scene scene, Lamp[] lamps) {
        public static Shown of(Geometry geometry, Scene scene) {
            return new Shown(geometry.of(scene), scene, Lamp.all(scene));
        }
    }

    Scene scene() {
        return shown.scene();
    }

    /** Whether mirror levels are kept as full rows. */
    boolean keepsRows() {
        return options.storage() == MirrorStorage.FULL_ROWS;
    }

    int depth() {
        return scene().picture().depth();
    }

    Sampling sampling() {
        return scene().picture().sampling();
    }

    int tilesX() {
        return (scene().picture().width() + Film.TILE - 1) / Film.TILE;
    }

    int tileCount() {
        return tilesX() * ((scene().picture().height() + Film.TILE - 1) / Film.TILE);
    }

    /**
     * A level's plan, with the lights that its layers were computed for, and whether each light's
     * effective weight changes: colour, intensity, on or solo; whether it was dark; and the key of sums that may be kept
     * because one light alone is edited again and again, or null.
     */
    public record Level(LevelPlan plan, Lamp[] lamps, Lamp[] lampsBefore, boolean[] reweighted, boolean[] darkBefore,
            BranchSums.Key key) {

        public static Level of(LevelPlan plan, Scene known, Lamp[] lamps, RepeatedEdit repeat) {
            boolean[] reweighted = new boolean[lamps.length];
            boolean[] dark = new boolean[lamps.length];
            Lamp[] lampsBefore = new Lamp[lamps.length];
            for (int l = 0; l < lamps.length; l++) {
                LayerStamp stamp = plan.layers().get(l).before();
                lampsBefore[l] = stamp == null ? null : Lamp.shining(stamp.light(), known);
                int from = plan.layers().get(l).from();
                Lamp before = from < 0 ? null : Lamp.of(known.lights().get(from), known);
                dark[l] = before == null || before.isDark();
                reweighted[l] = before == null || before.red() != lamps[l].red()
                        || before.green() != lamps[l].green() || before.blue() != lamps[l].blue();
            }
            int only = plan.materials().isEmpty() ? onlyChange(plan, reweighted) : -1;
            return new Level(plan, lamps, lampsBefore, reweighted, dark, repeat.next(only, lamps.length));
        }

        /** The only light whose contribution changes, or −1. */
        private static int onlyChange(LevelPlan plan, boolean[] reweighted) {
            int only = -1;
            for (int l = 0; l < reweighted.length; l++) {
                if (reweighted[l] || !(plan.layers().get(l).update() instanceof LightUpdate.Keep)) {
                    if (only >= 0) {
                        return -1;
                    }
                    only = l;
                }
            }
            return plan.compose() ? -1 : only;
        }

        /** The layers over one tile's rows after the update; those not touched are the old ones. */
        LightLayer[] layers(TileLevel old, LayerUpdater updater, Progress progress) {
            LightLayer[] layers = new LightLayer[lamps.length];
            for (int l = 0; l < lamps.length && !progress.isCancelled(); l++) {
                LayerPlan layer = plan.layers().get(l);
                LightLayer before = layer.from() < 0 ? null : old.layers()[layer.from()];
                if (before == null) {
                    // Never lit, or a mirror level that a deeper recursion added while the light was dark.
                    layers[l] = lamps[l].isDark() ? null : updater.full(old.rows(), lamps[l]);
                } else {
                    LightLayer ready = layer.update() instanceof LightUpdate.FullRecompute ? before
                            : updater.speculars(old.rows(), lampsBefore[l], before, plan.materials().speculars());
                    layers[l] = updater.update(old.rows(), lampsBefore[l], lamps[l], ready, layer.update());
                }
            }
            return layers;
        }

        /** Whether anti-aliasing may see other edges of lights than before: it sees neither weights nor falloffs. */
        boolean recodes(TileLevel old, LightLayer[] layers) {
            boolean same = !plan.compose() && plan.materials().isEmpty();
            for (int l = 0; same && l < lamps.length; l++) {
                same = (layers[l] == old.layers()[l] || keepsStates(plan.layers().get(l).update())) && darkBefore[l] == lamps[l].isDark();
            }
            return !same;
        }

        private static boolean keepsStates(LightUpdate update) {
            return switch (update) {
                case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> true;
                case LightUpdate.Partial p -> p.cone() == ConeChange.NONE;
                case LightUpdate.FullRecompute _ -> false;
            };
        }

        /** Whether any row's colour may differ from before, its mirror image left out. */
        boolean recolors(TileLevel old, LightLayer[] layers) {
            if (plan.compose() || plan.materials().recolored().isIn(old.rows())) {
                return true;
            }
            for (int l = 0; l < lamps.length; l++) {
                int from = plan.layers().get(l).from();
                LightLayer before = from < 0 ? null : old.layers()[from];
                boolean shone = before != null && before.lit() > 0;
                boolean shines = layers[l] != null && layers[l].lit() > 0;
                if ((before != layers[l] || reweighted[l]) && (shone || shines)) {
                    return true;
                }
            }
            return false;
        }
    }
}
