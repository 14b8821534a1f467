package lightning.scene.node;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;

/** First user of each material among some shapes, in the order of the shapes. */
public final class MaterialUsers {
    private final Map<String, String> users;

    private MaterialUsers(Map<String, String> users) {
        this.users = users;
    }

    static MaterialUsers of(List<Shape> shapes) {
        Map<String, String> users = new LinkedHashMap<>();
        shapes.forEach(s -> users.putIfAbsent(s.material(), s.name()));
        return new MaterialUsers(users);
    }

    /** Returns the names of the materials, in that order. */
    public Set<String> materials() {
        return Collections.unmodifiableSet(users.keySet());
    }

    /**
     * Returns the users after replacing some shapes; empty if only a full walk can find them. For a material that was both added and
     * removed, the first user of all shapes precedes the change or is within it.
     */
    Optional<MaterialUsers> replace(MaterialUsers removed, MaterialUsers added) {
        Map<String, String> merged = new LinkedHashMap<>(users);
        int first = 0;
        for (Map.Entry<String, String> user : removed.users.entrySet()) {
            if (user.getValue().equals(users.get(user.getKey()))) {
                String next = added.users.get(user.getKey());
                if (next == null) {
                    return Optional.empty();
                }
                first++;
                merged.put(user.getKey(), next);
            }
        }
        boolean ordered = first < 2 || List.copyOf(removed.materials()).equals(List.copyOf(added.materials()));
        return ordered && removed.materials().containsAll(added.materials()) ? Optional.of(new MaterialUsers(merged)) : Optional.empty();
    }

    /**
     * Checks that all materials exist.
     *
     * @throws RefusalException if one does not
     */
    public void check(Set<String> materialNames) {
        users.forEach((material, shape) -> {
            if (!materialNames.contains(material)) {
                throw new RefusalException("object " + Quote.of(shape) + ": there is no material " + Quote.of(material));
            }
        });
    }
}
