package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import lightning.render.cache.CachedLight;
import lightning.render.cache.TileLevel;
import lightning.render.shading.BranchSums;
import lightning.render.shading.LightLayer;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;

/**
 * The update of a level's layers.
 *
 * @param layers  one for each light of the wanted scene, in its order
 * @param droppedLights the names of lights whose layers go (§4.6)
 * @param recomposeAll whether the equation must be closed anew everywhere: a change of ambience,
 *                background or of which lights there are
 * @param materials what is done to the rows of materials that changed
 * @param key     of sums that may be kept because one light alone is edited again and again, or null
 */
public record LevelPlan(List<LayerPlan> layers, List<String> droppedLights, boolean recomposeAll, MaterialUpdate materials,
        BranchSums.Key key) {
    /** Stands for the place of a light where several are edited, or what lights fall on. */
    public static final int SEVERAL = -2;

    public LevelPlan {
        layers = List.copyOf(layers);
        droppedLights = List.copyOf(droppedLights);
    }

    /** One that keeps no sums. */
    public LevelPlan(List<LayerPlan> layers, List<String> dropped, boolean compose, MaterialUpdate materials) {
        this(layers, dropped, compose, materials, null);
    }

    /**
     * The update that recomputes some lights' contributions for the scene shown, and keeps all else.
     *
     * @param refreshed tells the lights to recompute
     */
    public static LevelPlan refresh(Scene scene, List<CachedLight> lights, MaterialTable materials, Predicate<CachedLight> refreshed) {
        List<LayerPlan> layers = new ArrayList<>();
        for (CachedLight light : lights) {
            layers.add(LayerPlan.of(WeightedLight.of(light.light(), scene), light,
                    refreshed.test(light) ? new LightUpdate.Refresh() : new LightUpdate.Keep(), ShapeChange.NONE, scene));
        }
        return new LevelPlan(layers, List.of(), true, MaterialUpdate.none(materials));
    }

    LevelPlan withKey(BranchSums.Key sums) {
        return new LevelPlan(layers, droppedLights, recomposeAll, materials, sums);
    }

    /** The place of the only light whose contribution changes, {@link BranchSums.Key#NO_LIGHT} where no light is edited, or {@link #SEVERAL}. */
    public int singleChange() {
        int only = BranchSums.Key.NO_LIGHT;
        for (int l = 0; l < layers.size(); l++) {
            if (layers.get(l).changesImage()) {
                if (only >= 0) {
                    return SEVERAL;
                }
                only = l;
            }
        }
        if (only >= 0) {
            return recomposeAll || !materials.isEmpty() ? SEVERAL : only;
        }
        return preservesLights() ? only : SEVERAL;
    }

    /** Whether all lights stay at their places, and of every row's material what they need to know: where no light is edited, neither is their sum. */
    private boolean preservesLights() {
        boolean isPreserved =
                droppedLights.isEmpty() && materials.specularChanged().isEmpty() && materials.mirroringChanged().isEmpty()
                        && materials.textureChanged().isEmpty();
        for (int l = 0; l < layers.size() && isPreserved; l++) {
            isPreserved = layers.get(l).base() != null && layers.get(l).base().index() == l;
        }
        return isPreserved;
    }

    /**
     * The lights after the update, and what their layers are then computed for.
     *
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    public List<CachedLight> lightsAfter(UpdateMethod method, double minFalloff) {
        List<CachedLight> lights = new ArrayList<>();
        for (LayerPlan layer : layers) {
            lights.add(new CachedLight(lights.size(), layer.light(), layer.stamp(method, minFalloff)));
        }
        return lights;
    }

    /** Whether anti-aliasing may see other edges of lights than before. */
    public boolean canChangeEdges(TileLevel old, LightLayer[] after) {
        boolean recodes = recomposeAll || !materials.isEmpty();
        for (int l = 0; l < after.length && !recodes; l++) {
            recodes = layers.get(l).canChangeEdges(old, after[l]);
        }
        return recodes;
    }

    /** Whether any row's color may differ from before, its mirror image left out. */
    public boolean canChangeColors(TileLevel old, LightLayer[] after) {
        boolean recolors = recomposeAll || materials.colorChanged().intersects(old.rows());
        for (int l = 0; l < after.length && !recolors; l++) {
            recolors = layers.get(l).canChangeColors(old, after[l]);
        }
        return recolors;
    }
}
