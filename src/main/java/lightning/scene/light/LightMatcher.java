package lightning.scene.light;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Matching of lights between two lists, the only rule by which renders, undo and descriptions tell an edited light from a new one.
 *
 * <p>Lights match by name. A light with a new name matches the first removed light that is equal except for its name. Otherwise, in a list
 * of the same length, it matches the removed light at the same index: it was renamed.
 */
public final class LightMatcher {
    private final List<Light> before;
    private final List<Light> after;
    private final int[] origins;
    private final boolean[] used;

    public LightMatcher(List<Light> before, List<Light> after) {
        this.before = before;
        this.after = after;
        origins = new int[after.size()];
        used = new boolean[before.size()];
        Arrays.fill(origins, -1);
        Map<String, Integer> indices = HashMap.newHashMap(before.size());
        for (int i = 0; i < before.size(); i++) {
            indices.put(before.get(i).name(), i);
        }
        for (int i = 0; i < origins.length; i++) {
            match(i, indices.getOrDefault(after.get(i).name(), -1));
        }
        matchRenamed();
    }

    private void match(int light, int origin) {
        origins[light] = origin;
        if (origin >= 0) {
            used[origin] = true;
        }
    }

    private void matchRenamed() {
        Map<Light, Deque<Integer>> removed = new HashMap<>();
        for (int i : removedIndices()) {
            removed.computeIfAbsent(withoutName(before.get(i)), _ -> new ArrayDeque<>()).add(i);
        }
        if (removed.isEmpty()) {
            return;
        }
        for (int i = 0; i < origins.length; i++) {
            Deque<Integer> candidates = origins[i] < 0 ? removed.get(withoutName(after.get(i))) : null;
            while (candidates != null && !candidates.isEmpty() && origins[i] < 0) {
                int origin = candidates.remove();
                match(i, used[origin] ? -1 : origin);
            }
            if (origins[i] < 0 && before.size() == after.size() && !used[i]) {
                match(i, i);
            }
        }
    }

    private static Light withoutName(Light light) {
        return light.withName("_");
    }

    public List<Light> before() {
        return before;
    }

    public List<Light> after() {
        return after;
    }

    /** Returns the old index of the light that is now at {@code index}, or −1 if it is new. */
    public int originIndex(int index) {
        return origins[index];
    }

    /** Returns the old indices of removed lights, ascending. */
    public List<Integer> removedIndices() {
        List<Integer> removed = new ArrayList<>();
        for (int i = 0; i < used.length; i++) {
            if (!used[i]) {
                removed.add(i);
            }
        }
        return removed;
    }
}
