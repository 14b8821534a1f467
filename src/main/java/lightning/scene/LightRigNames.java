package lightning.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;

/** Table of the names of a rig's lights and groups, shared by all rigs with the same names. */
final class LightRigNames {
    private final List<Light> lights;
    private final List<LightGroup> lightGroups;
    private final Map<String, Integer> lightIndices;
    private final Map<String, Integer> groupIndices;
    /** Last stage found to have none of the names; null for none. Any thread may set it to any such stage. */
    private Stage disjointStage;

    /** @throws IllegalArgumentException if two of them have the same name */
    LightRigNames(List<Light> lights, List<LightGroup> lightGroups) {
        this.lights = lights;
        this.lightGroups = lightGroups;
        lightIndices = HashMap.newHashMap(lights.size());
        groupIndices = HashMap.newHashMap(lightGroups.size());
        for (Light light : lights) {
            if (lightIndices.putIfAbsent(light.name(), lightIndices.size()) != null) {
                throw duplicateName("light", light.name());
            }
        }
        for (LightGroup group : lightGroups) {
            if (lightIndices.containsKey(group.name()) || groupIndices.putIfAbsent(group.name(), groupIndices.size()) != null) {
                throw duplicateName("light group", group.name());
            }
        }
    }

    /** Returns the index of the light group of that name, or −1. */
    int groupIndex(String name) {
        return groupIndices.getOrDefault(name, -1);
    }

    /** Returns the index of the light of that name, or −1. */
    int lightIndex(String name) {
        return lightIndices.getOrDefault(name, -1);
    }

    /**
     * Checks a stage for name conflicts, unless the last one checked has the same names.
     *
     * @throws IllegalArgumentException if a shape or a group has the name of a light or a light group
     */
    void checkDisjoint(Stage stage) {
        Stage checked = disjointStage;
        if (checked != null && checked.sharesNames(stage)) {
            return;
        }
        for (Light light : lights) {
            if (stage.hasNode(light.name())) {
                throw duplicateName("light", light.name());
            }
        }
        for (LightGroup group : lightGroups) {
            if (stage.hasNode(group.name())) {
                throw duplicateName("light group", group.name());
            }
        }
        disjointStage = stage;
    }

    private static IllegalArgumentException duplicateName(String kind, String name) {
        return new IllegalArgumentException(kind + " " + Quote.of(name) + ": the name is already taken");
    }
}
