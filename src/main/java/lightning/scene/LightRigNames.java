package lightning.scene;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import lightning.base.text.Quote;

/** The names of a rig's lights and banks, shared by all rigs that differ in their attributes alone. */
final class LightRigNames {
    private final List<Light> lights;
    private final List<LightGroup> lightGroups;
    private final Map<String, Integer> lightIndices;
    private final Map<String, Integer> groupIndices;
    /** A stage that has none of the names; null where none was asked. Any thread may set it: each that does is right. */
    private Stage disjointStage;

    /**
     * @throws IllegalArgumentException if two of them have the same name
     */
    LightRigNames(List<Light> lights, List<LightGroup> banks) {
        this.lights = lights;
        this.lightGroups = banks;
        lightIndices = HashMap.newHashMap(lights.size());
        groupIndices = HashMap.newHashMap(banks.size());
        for (Light light : lights) {
            if (lightIndices.putIfAbsent(light.name(), lightIndices.size()) != null) {
                throw duplicateName("light", light.name());
            }
        }
        for (LightGroup bank : banks) {
            if (lightIndices.containsKey(bank.name()) || groupIndices.putIfAbsent(bank.name(), groupIndices.size()) != null) {
                throw duplicateName("bank", bank.name());
            }
        }
    }

    /** The place of the bank of that name, or −1. */
    int groupIndex(String name) {
        return groupIndices.getOrDefault(name, -1);
    }

    /** The place of the light of that name, or −1. */
    int lightIndex(String name) {
        return lightIndices.getOrDefault(name, -1);
    }

    /**
     * Asks a stage for the names, unless the one asked last has the same shapes.
     *
     * @throws IllegalArgumentException if a shape or a group has the name of a light or a bank
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
        for (LightGroup bank : lightGroups) {
            if (stage.hasNode(bank.name())) {
                throw duplicateName("bank", bank.name());
            }
        }
        disjointStage = stage;
    }

    private static IllegalArgumentException duplicateName(String kind, String name) {
        return new IllegalArgumentException(kind + " " + Quote.of(name) + ": the name is already taken");
    }
}
