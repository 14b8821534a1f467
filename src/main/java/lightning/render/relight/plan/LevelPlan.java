package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import lightning.render.cache.CachedLight;
import lightning.render.cache.CachedScene;
import lightning.render.cache.TileLevel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.BranchSums;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Update of a level's layers.
 *
 * @param layers        one plan for each light of the target scene, in its order
 * @param droppedLights names of lights whose layers are dropped (§4.6)
 * @param recomposeAll  true if the equation must be evaluated everywhere: the ambience, background or set of lights changed
 * @param materials     update of the rows of changed materials
 * @param key           key of partial sums that may be cached because only one light is edited repeatedly
 */
public record LevelPlan(List<LayerPlan> layers, List<String> droppedLights, boolean recomposeAll, MaterialUpdate materials,
        BranchSums.@Nullable Key key) {
    /** Light index if several lights or their surfaces are edited. */
    public static final int SEVERAL = -2;

    public LevelPlan {
        layers = List.copyOf(layers);
        droppedLights = List.copyOf(droppedLights);
    }

    /** Creates a plan that caches no partial sums. */
    public LevelPlan(List<LayerPlan> layers, List<String> dropped, boolean compose, MaterialUpdate materials) {
        this(layers, dropped, compose, materials, null);
    }

    /**
     * Creates a plan that recomputes some lights' contributions for the shown scene and keeps the rest.
     *
     * @param known     the shown scene
     * @param refreshed selects the lights to recompute
     */
    public static LevelPlan refresh(CachedScene known, MaterialTable materials, Predicate<CachedLight> refreshed) {
        Scene scene = known.scene();
        List<LayerPlan> layers = new ArrayList<>();
        for (CachedLight light : known.lights()) {
            layers.add(LayerPlan.of(WeightedLight.of(light.light(), scene), light,
                    refreshed.test(light) ? new LightUpdate.Refresh() : new LightUpdate.Keep(), ShapeChange.NONE, scene,
                    scene.stage(), ShapeChange.NONE));
        }
        return new LevelPlan(layers, List.of(), true, MaterialUpdate.none(materials));
    }

    LevelPlan withKey(BranchSums.@Nullable Key sums) {
        return new LevelPlan(layers, droppedLights, recomposeAll, materials, sums);
    }

    /**
     * Returns the index of the only light whose contribution changes, {@link BranchSums.Key#NO_LIGHT} if no light is edited, or
     * {@link #SEVERAL}.
     */
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

    /**
     * Returns whether all lights keep their order and every row's material terms stay the same, so that the lights' sum is
     * unchanged if no light is edited.
     */
    private boolean preservesLights() {
        boolean isPreserved =
                droppedLights.isEmpty() && materials.specularChanged().isEmpty() && materials.mirroringChanged().isEmpty()
                        && materials.textureChanged().isEmpty();
        for (int l = 0; l < layers.size() && isPreserved; l++) {
            CachedLight base = layers.get(l).base();
            isPreserved = base != null && base.index() == l;
        }
        return isPreserved;
    }

    /**
     * Returns the cached lights after the update, with the stamps of their layers.
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

    /** Returns whether the colors by which anti-aliasing detects edges may change, apart from mirror images. */
    public boolean canChangeEdges(TileLevel old, LightLayer[] after) {
        boolean recodes = recomposeAll || !materials.isEmpty();
        for (int l = 0; l < after.length && !recodes; l++) {
            recodes = layers.get(l).canChangeEdges(old, after[l]);
        }
        return recodes;
    }

    /** Returns whether any row's color may change, apart from its mirror image. */
    public boolean canChangeColors(TileLevel old, LightLayer[] after) {
        boolean recolors = recomposeAll || materials.colorChanged().intersects(old.rows());
        for (int l = 0; l < after.length && !recolors; l++) {
            recolors = layers.get(l).canChangeColors(old, after[l]);
        }
        return recolors;
    }
}
