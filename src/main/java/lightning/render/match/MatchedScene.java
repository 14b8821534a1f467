package lightning.render.match;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/** Scenes whose lights are multiplied by factors of a match. */
public final class MatchedScene {
    private MatchedScene() {}

    /**
     * Returns a scene with its lights moved and {@linkplain #multiplied multiplied}.
     *
     * @param result match of a scene with the same lights
     */
    public static Scene of(Scene scene, MatchResult result) {
        Scene matched = result.moved().map(moved -> scene.withLights(moved.lights())
                .withWorld(World.ROTATION.copy(moved.world(), scene.world()))).orElse(scene);
        for (LightFactor factor : result.factors()) {
            Contribution part = factor.light();
            Optional<Light> light = part.light(matched);
            matched = light.isPresent() ? matched.withLight(multiplied(light.get(), factor))
                    : part.with(matched, v -> v.withIntensity(Math.min(part.maxIntensity(), v.intensity() * factor.red())));
        }
        return matched;
    }

    /**
     * Returns a light with its light multiplied, within the limits of scenes. If its color changes, the largest channel of the color stays, and
     * the intensity takes the rest; a black light stays black.
     */
    public static Light multiplied(Light light, LightFactor factor) {
        double max = SceneLimits.MAX_INTENSITY / light.maxFactor();
        if (factor.isGray() || light.color().isBlack()) {
            return light.withIntensity(Math.min(max, light.intensity() * factor.red()));
        }
        Rgb color = light.color();
        Rgb changed = new Rgb(color.r() * factor.red(), color.g() * factor.green(), color.b() * factor.blue());
        double ratio = changed.max() / color.max();
        return ratio == 0 ? light.withIntensity(0)
                : light.withColor(changed.times(1 / ratio)).withIntensity(Math.min(max, light.intensity() * ratio));
    }
}
