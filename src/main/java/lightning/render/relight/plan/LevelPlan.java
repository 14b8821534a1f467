package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.List;
import lightning.render.cache.KnownLight;

/**
 * The update of a level's layers.
 *
 * @param layers  one for each light of the wanted scene, in its order
 * @param dropped the names of lights whose layers go (§4.6)
 * @param compose whether the equation must be closed anew everywhere: a change of ambience,
 *                background or of which lights there are
 * @param materials what is done to the rows of materials that changed
 */
public record LevelPlan(List<LayerPlan> layers, List<String> dropped, boolean compose, MaterialUpdate materials) {
    public LevelPlan {
        layers = List.copyOf(layers);
        dropped = List.copyOf(dropped);
    }

    /** Whether all lights stay at their places, and of every row's material what they need to know: where no light is edited, neither is their sum. */
    public boolean keepsLights() {
        boolean keeps =
                dropped.isEmpty() && materials.speculars().isEmpty() && materials.mirrors().isEmpty() && materials.retextured().isEmpty();
        for (int l = 0; l < layers.size() && keeps; l++) {
            keeps = layers.get(l).from() != null && layers.get(l).from().place() == l;
        }
        return keeps;
    }

    /** The lights after an update that scales nothing, and what their layers are then computed for. */
    public List<KnownLight> after() {
        return after(false, 1);
    }

    /**
     * The lights after the update, and what their layers are then computed for.
     *
     * @param scaled       whether the update is carried out by ratios
     * @param leastFalloff the least falloff of rows whose falloff was scaled
     */
    public List<KnownLight> after(boolean scaled, double leastFalloff) {
        List<KnownLight> lights = new ArrayList<>();
        for (LayerPlan layer : layers) {
            lights.add(new KnownLight(lights.size(), layer.light(), layer.stamp(scaled, leastFalloff)));
        }
        return lights;
    }
}
