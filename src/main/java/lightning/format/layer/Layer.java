package lightning.format.layer;

import java.util.ArrayList;
import java.util.List;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.composition.LightComponent;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/** Color layer of an image; all layers add up to the image. */
sealed interface Layer {
    /** Background where camera rays hit nothing. */
    record Background() implements Layer {}

    /** Ambient term of directly visible surfaces. */
    record Ambient() implements Layer {}

    /** Light that directly visible surfaces emit themselves. */
    record Emission() implements Layer {}

    /**
     * One term of some lights on directly visible surfaces.
     *
     * @param name name of the light; {@link #ENVIRONMENT} for all environment lights
     * @param first index of their first light among the active lights
     * @param end index after their last light
     * @param part term of the lighting equation
     */
    record Lights(String name, int first, int end, LightComponent part) implements Layer {}

    /**
     * Gathered light of directly visible surfaces, and what they reflect of their surroundings if that is blurred.
     *
     * @param settings what is gathered
     */
    record Gathered(GatherSettings settings) implements Layer {}

    /** Reflections, and the scene through transparent surfaces. */
    record Reflections() implements Layer {}

    String ENVIRONMENT = "environment";

    /**
     * Returns the layers of an image, in summation order.
     *
     * @param all true for layers of lights that are off and of emission without glowing materials too, which are black
     */
    static List<Layer> of(Scene scene, boolean all) {
        List<Layer> layers = new ArrayList<>(List.of(new Background(), new Ambient()));
        if (all || scene.stage().rendered().materials().stream().anyMatch(m -> !m.emission().isBlack())) {
            layers.add(new Emission());
        }
        WeightedLight[] lights = WeightedLight.ofScene(scene);
        List<Light> sceneLights = scene.lights();
        for (int i = 0; i < sceneLights.size(); i++) {
            if (all || !lights[i].isDark() || scene.world().fog().isPresent() && !lights[i].isDarkInFog()) {
                add(sceneLights.get(i).name(), i, i + 1, layers);
            }
        }
        if (lights.length > sceneLights.size()) {
            add(ENVIRONMENT, sceneLights.size(), lights.length, layers);
        }
        GatherSettings.of(scene).ifPresent(settings -> layers.add(new Gathered(settings)));
        layers.add(new Reflections());
        return layers;
    }

    private static void add(String name, int first, int end, List<Layer> layers) {
        layers.add(new Lights(name, first, end, LightComponent.DIFFUSE));
        layers.add(new Lights(name, first, end, LightComponent.SPECULAR));
    }
}
