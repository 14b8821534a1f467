package lightning.relight.plan;

import java.util.List;

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
}
