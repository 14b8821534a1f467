package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import lightning.render.cache.KnownLight;
import lightning.render.cache.TileLevel;
import lightning.render.shading.BranchSums;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;

/**
 * The update of a level's layers.
 *
 * @param layers  one for each light of the wanted scene, in its order
 * @param dropped the names of lights whose layers go (§4.6)
 * @param compose whether the equation must be closed anew everywhere: a change of ambience,
 *                background or of which lights there are
 * @param materials what is done to the rows of materials that changed
 * @param key     of sums that may be kept because one light alone is edited again and again, or null
 */
public record LevelPlan(List<LayerPlan> layers, List<String> dropped, boolean compose, MaterialUpdate materials, BranchSums.Key key) {
    /** Stands for the place of a light where several are edited, or what lights fall on. */
    public static final int MUCH = -2;

    public LevelPlan {
        layers = List.copyOf(layers);
        dropped = List.copyOf(dropped);
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
    public static LevelPlan refresh(Scene scene, List<KnownLight> lights, MaterialTable materials, Predicate<KnownLight> refreshed) {
        List<LayerPlan> layers = new ArrayList<>();
        for (KnownLight light : lights) {
            layers.add(LayerPlan.of(Luminaire.of(light.light(), scene), light,
                    refreshed.test(light) ? new LightUpdate.Refresh() : new LightUpdate.Keep(), ShapeChange.NONE, scene));
        }
        return new LevelPlan(layers, List.of(), true, MaterialUpdate.none(materials));
    }

    LevelPlan withKey(BranchSums.Key sums) {
        return new LevelPlan(layers, dropped, compose, materials, sums);
    }

    /** The place of the only light whose contribution changes, {@link BranchSums.Key#NO_LIGHT} where no light is edited, or {@link #MUCH}. */
    public int onlyChange() {
        int only = BranchSums.Key.NO_LIGHT;
        for (int l = 0; l < layers.size(); l++) {
            if (layers.get(l).changes()) {
                if (only >= 0) {
                    return MUCH;
                }
                only = l;
            }
        }
        if (only >= 0) {
            return compose || !materials.isEmpty() ? MUCH : only;
        }
        return keepsLights() ? only : MUCH;
    }

    /** Whether all lights stay at their places, and of every row's material what they need to know: where no light is edited, neither is their sum. */
    private boolean keepsLights() {
        boolean keeps =
                dropped.isEmpty() && materials.speculars().isEmpty() && materials.mirrors().isEmpty() && materials.retextured().isEmpty();
        for (int l = 0; l < layers.size() && keeps; l++) {
            keeps = layers.get(l).from() != null && layers.get(l).from().place() == l;
        }
        return keeps;
    }

    /**
     * The lights after the update, and what their layers are then computed for.
     *
     * @param leastFalloff {@link LayerUpdater#leastFalloff} of all threads
     */
    public List<KnownLight> after(UpdateMethod method, double leastFalloff) {
        List<KnownLight> lights = new ArrayList<>();
        for (LayerPlan layer : layers) {
            lights.add(new KnownLight(lights.size(), layer.light(), layer.stamp(method, leastFalloff)));
        }
        return lights;
    }

    /** Whether anti-aliasing may see other edges of lights than before. */
    public boolean recodes(TileLevel old, LightLayer[] after) {
        boolean recodes = compose || !materials.isEmpty();
        for (int l = 0; l < after.length && !recodes; l++) {
            recodes = layers.get(l).recodes(old, after[l]);
        }
        return recodes;
    }

    /** Whether any row's colour may differ from before, its mirror image left out. */
    public boolean recolors(TileLevel old, LightLayer[] after) {
        boolean recolors = compose || materials.recolored().isIn(old.rows());
        for (int l = 0; l < after.length && !recolors; l++) {
            recolors = layers.get(l).recolors(old, after[l]);
        }
        return recolors;
    }
}
