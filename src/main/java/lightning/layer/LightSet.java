package lightning.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.render.shading.FilmParts;
import lightning.render.shading.WeightedLight;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;

/**
 * Contributions that share layers: one light, the lights of a group, or one environment.
 *
 * @param name name of the contribution or group, which no other set of the scene has
 */
record LightSet(String name, Set<Contribution> contributions) {
    /**
     * Returns the sets of a scene, in its order; environments come last.
     *
     * @param all     true for sets of lights that are off too
     * @param grouped true for one set per light group in place of its lights
     */
    static List<LightSet> of(Scene scene, boolean all, boolean grouped) {
        WeightedLight[] weighted = WeightedLight.ofScene(scene);
        Map<String, Set<Contribution>> members = new LinkedHashMap<>();
        List<LightSet> sets = new ArrayList<>();
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            if (all || !weighted[i].isDark() || scene.world().fog().isPresent() && !weighted[i].isDarkInFog()) {
                String group = grouped ? light.lightGroup() : "";
                if (group.isEmpty()) {
                    sets.add(of(scene, Contribution.of(light)));
                } else {
                    members.computeIfAbsent(group, _ -> new HashSet<>()).add(Contribution.of(light));
                }
            }
        }
        members.forEach((group, lights) -> sets.add(new LightSet(group, Set.copyOf(lights))));
        Contribution.environments(scene).forEach(part -> sets.add(of(scene, part)));
        return sets;
    }

    private static LightSet of(Scene scene, Contribution part) {
        return new LightSet(part.name(scene), Set.of(part));
    }

    boolean isEnvironment() {
        return contributions.stream().noneMatch(SceneElement.OfLight.class::isInstance);
    }

    /** Returns the films of each set, and last those of no set. Dark films are in none. */
    static List<BitSet> films(List<LightSet> sets, FilmParts parts) {
        BitSet rest = parts.shining();
        List<BitSet> films = new ArrayList<>();
        for (LightSet set : sets) {
            BitSet its = parts.of(set.contributions);
            its.and(parts.shining());
            rest.andNot(its);
            films.add(its);
        }
        films.add(rest);
        return films;
    }

    /** Returns the indices of its lights among all lights of a scene; those of an environment follow the scene's own lights. */
    int[] indices(Scene scene) {
        return contributions.stream().flatMapToInt(part -> Arrays.stream(part.effectiveLights(scene))).sorted().toArray();
    }
}
