package lightning.format.layer;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.render.shading.WeightedLight;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;

/**
 * Lights that share layers: one light, a light group, or an environment.
 *
 * @param name          name of the light or group, or one that no other set has for all environments together
 * @param lights        names of its lights; empty for an environment
 * @param isEnvironment whether it is the environment: its small bright parts, which are lights, and the rest of it
 */
record LightSet(String name, Set<String> lights, boolean isEnvironment) {
    /**
     * Returns the sets of a scene, in its order; that of the environment comes last.
     *
     * @param all     true for sets of lights that are off too
     * @param grouped true for one set per light group in place of its lights
     */
    static List<LightSet> of(Scene scene, boolean all, boolean grouped) {
        WeightedLight[] weighted = WeightedLight.ofScene(scene);
        Map<String, List<String>> members = new LinkedHashMap<>();
        List<LightSet> sets = new ArrayList<>();
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            if (all || !weighted[i].isDark() || scene.world().fog().isPresent() && !weighted[i].isDarkInFog()) {
                String group = grouped ? light.lightGroup() : "";
                if (group.isEmpty()) {
                    sets.add(new LightSet(light.name(), Set.of(light.name()), false));
                } else {
                    members.computeIfAbsent(group, _ -> new ArrayList<>()).add(light.name());
                }
            }
        }
        members.forEach((group, lights) -> sets.add(new LightSet(group, Set.copyOf(lights), false)));
        if (scene.world().hasEnvironment()) {
            sets.add(new LightSet(Contribution.environmentName(Stream.concat(
                    scene.lights().stream().map(Light::name), sets.stream().map(LightSet::name)).toList()), Set.of(), true));
        }
        return sets;
    }

    /** Returns the indices of its lights among all lights of a scene; those of an environment follow the scene's own lights. */
    int[] indices(Scene scene) {
        int own = scene.lights().size();
        int count = scene.rig().effectiveLights().size();
        return IntStream.range(0, count).filter(i -> i < own ? lights.contains(scene.lights().get(i).name()) : isEnvironment).toArray();
    }
}
