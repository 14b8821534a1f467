package lightning.scene.light;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.node.NodeNames;
import org.jspecify.annotations.Nullable;

/** Table of the names of a rig's lights and groups, shared by all rigs with the same names. */
final class LightRigNames {
    private final List<Light> lights;
    private final List<LightGroup> lightGroups;
    private final Map<String, Integer> lightIndices;
    private final Map<String, Integer> groupIndices;
    /** Last names of nodes found to have none of these. Any thread may set it to any such names. */
    private @Nullable NodeNames disjoint;

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
     * Checks the names of nodes for conflicts, unless the last ones checked are the same.
     *
     * @throws IllegalArgumentException if a shape or a group has the name of a light or a light group
     */
    void checkDisjoint(NodeNames nodes) {
        if (disjoint == nodes) {
            return;
        }
        for (Light light : lights) {
            if (nodes.contains(light.name())) {
                throw duplicateName("light", light.name());
            }
        }
        for (LightGroup group : lightGroups) {
            if (nodes.contains(group.name())) {
                throw duplicateName("light group", group.name());
            }
        }
        disjoint = nodes;
    }

    private static IllegalArgumentException duplicateName(String kind, String name) {
        return new RefusalException(kind + " " + Quote.of(name) + ": the name is already taken");
    }
}
