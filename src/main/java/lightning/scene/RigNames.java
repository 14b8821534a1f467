package lightning.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.text.Quote;

/** The names of a rig's lights, shared by all rigs that differ in other attributes of their lights. */
final class RigNames {
    private final List<Light> lights;
    private final Map<String, Integer> places;
    /** A stage that has none of the names; null where none was asked. Any thread may set it: each that does is right. */
    private Stage apart;

    /**
     * @throws IllegalArgumentException if two lights have the same name
     */
    RigNames(List<Light> lights) {
        this.lights = lights;
        places = HashMap.newHashMap(lights.size());
        for (Light light : lights) {
            if (places.putIfAbsent(light.name(), places.size()) != null) {
                throw taken(light);
            }
        }
    }

    /** The place of the light of that name, or −1. */
    int place(String name) {
        return places.getOrDefault(name, -1);
    }

    /**
     * Asks a stage for the names, unless the one asked last has the same shapes.
     *
     * @throws IllegalArgumentException if a shape or a group has the name of a light
     */
    void checkApart(Stage stage) {
        Stage known = apart;
        if (known != null && known.sharesNodesWith(stage)) {
            return;
        }
        for (Light light : lights) {
            if (stage.hasNode(light.name())) {
                throw taken(light);
            }
        }
        apart = stage;
    }

    private static IllegalArgumentException taken(Light light) {
        return new IllegalArgumentException("light " + Quote.of(light.name()) + ": the name is already taken");
    }
}
