package lightning.scene.light;

import java.util.List;
import lightning.scene.value.SceneLimits;

/**
 * Directional lights that represent one environment.
 *
 * @param units  at least one, as bright as for an environment with intensity and gain 1
 * @param factor intensity times gain of the environment, ≥ 0
 */
public record EnvironmentLights(List<Light> units, double factor) {
    /** Returns the lights as bright as the environment makes them. */
    public List<Light> lights() {
        return units.stream()
                .map(light -> light.withIntensity(Math.min(light.intensity() * factor, SceneLimits.MAX_ENVIRONMENT_LIGHT_INTENSITY)))
                .toList();
    }
}
