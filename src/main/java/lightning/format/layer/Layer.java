package lightning.format.layer;

import java.util.ArrayList;
import java.util.List;
import lightning.render.shading.LightComponent;
import lightning.render.shading.WeightedLight;
import lightning.scene.Light;
import lightning.scene.Scene;

/** One of the colors that add up to a picture. */
sealed interface Layer {
    /** What is seen where rays of the eye hit nothing. */
    record Background() implements Layer {}

    /** What surfaces show in the scene's ambience. */
    record Ambient() implements Layer {}

    /**
     * What some lights give where the eye sees their light fall, in no mirror.
     *
     * @param name  the light's; {@link #ENVIRONMENT} for all lights that an environment is made of
     * @param first their first among the lights that act
     * @param end   the one behind their last
     */
    record Lights(String name, int first, int end, LightComponent part) implements Layer {}

    /** All that is seen in mirrors and through clear surfaces. */
    record Reflections() implements Layer {}

    String ENVIRONMENT = "environment";

    /** The layers of a picture, in the order in which they are added. Lights that do not shine have none. */
    static List<Layer> of(Scene scene) {
        List<Layer> layers = new ArrayList<>(List.of(new Background(), new Ambient()));
        WeightedLight[] lights = WeightedLight.ofScene(scene);
        List<Light> sceneLights = scene.lights();
        for (int i = 0; i < sceneLights.size(); i++) {
            if (!lights[i].isDark()) {
                add(sceneLights.get(i).name(), i, i + 1, layers);
            }
        }
        if (lights.length > sceneLights.size()) {
            add(ENVIRONMENT, sceneLights.size(), lights.length, layers);
        }
        layers.add(new Reflections());
        return layers;
    }

    private static void add(String name, int first, int end, List<Layer> layers) {
        layers.add(new Lights(name, first, end, LightComponent.DIFFUSE));
        layers.add(new Lights(name, first, end, LightComponent.SPECULAR));
    }
}
