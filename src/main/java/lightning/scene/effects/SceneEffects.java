package lightning.scene.effects;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.scene.Scene;

/**
 * The effects that a scene calls for, and who calls for each.
 *
 * @param users for each effect that is called for the names of the lights, materials or shapes that do, in the order
 *                of the scene, each once; other effects have no entry
 * @param maxBounces   how many times a ray can bounce at most, mirrored or refracted: 0 where nothing mirrors or is clear
 */
public record SceneEffects(Map<RenderEffect, List<String>> users, int maxBounces) {
    private static final int MAX_NAMES = 6;

    public SceneEffects {
        var copy = new LinkedHashMap<RenderEffect, List<String>>();
        users.forEach((effect, names) -> copy.put(effect, List.copyOf(names)));
        users = Collections.unmodifiableMap(copy);
    }

    /** The effects of a scene. */
    public static SceneEffects of(Scene scene) {
        EffectUsers uses = EffectUsers.of(scene);
        var users = new LinkedHashMap<RenderEffect, List<String>>();
        for (RenderEffect effect : RenderEffect.ALL) {
            List<String> names = effect.users(uses).distinct().toList();
            if (!names.isEmpty()) {
                users.put(effect, names);
            }
        }
        return new SceneEffects(users, uses.depth());
    }

    /** Whether the scene calls for an effect. */
    public boolean has(RenderEffect effect) {
        return users.containsKey(effect);
    }

    /** Whether a ray can bounce: then parts of the picture are seen in mirrors or through clear surfaces. */
    public boolean spawnsSecondaryRays() {
        return maxBounces > 0;
    }

    /** Who calls for it; empty where nobody does. */
    public List<String> users(RenderEffect effect) {
        return users.getOrDefault(effect, List.of());
    }

    /** Why the scene calls for it, in a line: {@code up to 3 bounces: floor, eye}; empty where it does not. */
    public String reason(RenderEffect effect) {
        List<String> names = users(effect);
        String shown = String.join(", ", names.subList(0, Math.min(names.size(), MAX_NAMES)));
        String more = names.size() > MAX_NAMES ? " and " + (names.size() - MAX_NAMES) + " more" : "";
        return (effect == RenderEffect.REFLECTION && has(effect) ? "up to " + maxBounces + " bounces: " : "") + shown + more;
    }

    /** What the scene does without. */
    public Set<RenderEffect> unused() {
        var unused = new LinkedHashSet<>(RenderEffect.ALL);
        unused.removeAll(users.keySet());
        return unused;
    }
}
