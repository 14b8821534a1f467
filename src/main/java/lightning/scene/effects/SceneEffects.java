package lightning.scene.effects;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import lightning.base.text.Messages;
import lightning.scene.Scene;

/**
 * Effects used by a scene, with their users.
 *
 * @param users      for each used effect the unique names of its lights, materials or shapes, in scene order; unused effects have no entry
 * @param maxBounces maximum number of reflection and refraction bounces: 0 if nothing reflects or is transparent
 */
public record SceneEffects(Map<RenderEffect, List<String>> users, int maxBounces) {
    private static final int MAX_NAMES = 6;

    public SceneEffects {
        var copy = new LinkedHashMap<RenderEffect, List<String>>();
        users.forEach((effect, names) -> copy.put(effect, List.copyOf(names)));
        users = Collections.unmodifiableMap(copy);
    }

    /** Returns the effects of a scene. */
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

    /** Returns whether the scene uses an effect. */
    public boolean has(RenderEffect effect) {
        return users.containsKey(effect);
    }

    /** Returns whether rays can bounce, so that parts of the image are seen in mirrors or through transparent surfaces. */
    public boolean spawnsSecondaryRays() {
        return maxBounces > 0;
    }

    /** Returns the users of an effect; empty if unused. */
    public List<String> users(RenderEffect effect) {
        return users.getOrDefault(effect, List.of());
    }

    /** Returns the reason for an effect, in a line: {@code up to 3 bounces: floor, eye}; empty if unused. */
    public String reason(RenderEffect effect) {
        List<String> names = users(effect);
        String shown = String.join(", ", names.subList(0, Math.min(names.size(), MAX_NAMES)));
        String more = names.size() > MAX_NAMES ? Messages.tr(" and {0} more", names.size() - MAX_NAMES) : "";
        return effect == RenderEffect.REFLECTION && has(effect)
                ? Messages.count(maxBounces, "up to {0} bounce: {1}", "up to {0} bounces: {1}", maxBounces, shown + more) : shown + more;
    }

    /** Returns the unused effects. */
    public Set<RenderEffect> unused() {
        var unused = new LinkedHashSet<>(RenderEffect.ALL);
        unused.removeAll(users.keySet());
        return unused;
    }
}
