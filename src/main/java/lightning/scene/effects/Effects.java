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
 * @param callers for each effect that is called for the names of the lights, materials or shapes that do, in the order
 *                of the scene, each once; other effects have no entry
 * @param depth   how many times a ray can bounce at most, mirrored or refracted: 0 where nothing mirrors or is clear
 */
public record Effects(Map<Effect, List<String>> callers, int depth) {
    private static final int NAMES_SHOWN = 6;

    public Effects {
        var copy = new LinkedHashMap<Effect, List<String>>();
        callers.forEach((effect, names) -> copy.put(effect, List.copyOf(names)));
        callers = Collections.unmodifiableMap(copy);
    }

    /** The effects of a scene. */
    public static Effects of(Scene scene) {
        Uses uses = Uses.of(scene);
        var callers = new LinkedHashMap<Effect, List<String>>();
        for (Effect effect : Effect.ALL) {
            List<String> names = effect.callers(uses).distinct().toList();
            if (!names.isEmpty()) {
                callers.put(effect, names);
            }
        }
        return new Effects(callers, uses.depth());
    }

    /** Whether the scene calls for an effect. */
    public boolean has(Effect effect) {
        return callers.containsKey(effect);
    }

    /** Whether a ray can bounce: then parts of the picture are seen in mirrors or through clear surfaces. */
    public boolean bouncesRays() {
        return depth > 0;
    }

    /** Who calls for it; empty where nobody does. */
    public List<String> callers(Effect effect) {
        return callers.getOrDefault(effect, List.of());
    }

    /** Why the scene calls for it, in a line: {@code up to 3 bounces: floor, eye}; empty where it does not. */
    public String why(Effect effect) {
        List<String> names = callers(effect);
        String shown = String.join(", ", names.subList(0, Math.min(names.size(), NAMES_SHOWN)));
        String more = names.size() > NAMES_SHOWN ? " and " + (names.size() - NAMES_SHOWN) + " more" : "";
        return (effect == Effect.REFLECTION && has(effect) ? "up to " + depth + " bounces: " : "") + shown + more;
    }

    /** What the scene does without. */
    public Set<Effect> absent() {
        var absent = new LinkedHashSet<>(Effect.ALL);
        absent.removeAll(callers.keySet());
        return absent;
    }
}
