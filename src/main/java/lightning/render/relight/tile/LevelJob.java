package lightning.render.relight.tile;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.cache.TileLevel;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.shading.BranchSums;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;

/**
 * The update of a level.
 *
 * @param lights one for each light of the scene wanted, in its order
 * @param shapes what became of the shapes
 * @param key    of sums that may be kept because one light alone is edited again and again, or null
 */
public record LevelJob(LevelPlan plan, List<LightJob> lights, ShapeChange shapes, BranchSums.Key key) {

    /**
     * @param shapes what became of the shapes
     * @param known  the scene before
     * @param wanted the lights wanted
     */
    public static LevelJob of(LevelPlan plan, ShapeChange shapes, Scene known, Luminaire[] wanted, RepeatedEdit repeat) {
        List<LightJob> lights = new ArrayList<>();
        for (int l = 0; l < wanted.length; l++) {
            lights.add(LightJob.of(plan.layers().get(l), wanted[l], known));
        }
        return new LevelJob(plan, lights, shapes,
                repeat.next(shapes.isEmpty() ? onlyChange(plan, lights) : RepeatedEdit.MUCH, wanted.length));
    }

    /** The place of the only light whose contribution changes, where nothing else does, or what {@link RepeatedEdit#next} has for others. */
    private static int onlyChange(LevelPlan plan, List<LightJob> lights) {
        int only = BranchSums.Key.NO_LIGHT;
        for (int l = 0; l < lights.size(); l++) {
            if (lights.get(l).changes()) {
                if (only >= 0) {
                    return RepeatedEdit.MUCH;
                }
                only = l;
            }
        }
        if (only >= 0) {
            return plan.compose() || !plan.materials().isEmpty() ? RepeatedEdit.MUCH : only;
        }
        return plan.keepsLights() ? only : RepeatedEdit.MUCH;
    }

    /** The layers over one tile's rows after the update; those not touched are the old ones. */
    LightLayer[] layers(TileLevel old, LayerUpdater updater, Progress progress) {
        LightLayer[] layers = new LightLayer[lights.size()];
        for (int l = 0; l < layers.length && !progress.isCancelled(); l++) {
            layers[l] = lights.get(l).after(old, updater, plan.materials().speculars());
        }
        return layers;
    }

    /** Whether anti-aliasing may see other edges of lights than before. */
    boolean recodes(TileLevel old, LightLayer[] layers) {
        boolean recodes = plan.compose() || !plan.materials().isEmpty();
        for (int l = 0; l < layers.length && !recodes; l++) {
            recodes = lights.get(l).recodes(old, layers[l]);
        }
        return recodes;
    }

    /** Whether any row's colour may differ from before, its mirror image left out. */
    boolean recolors(TileLevel old, LightLayer[] layers) {
        boolean recolors = plan.compose() || plan.materials().recolored().isIn(old.rows());
        for (int l = 0; l < layers.length && !recolors; l++) {
            recolors = lights.get(l).recolors(old, layers[l]);
        }
        return recolors;
    }
}
