package lightning.editor.window.model;

import java.util.Set;
import java.util.stream.Collectors;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import lightning.editor.document.KeyPlace;
import lightning.scene.shot.AnimatedScene;

/** Which keys of the shot the artist has chosen: what the commands about keys act on. */
public final class KeyChoice {
    private final ReadOnlyObjectWrapper<Set<KeyPlace>> keys = new ReadOnlyObjectWrapper<>(Set.of());
    private final Runnable changed;

    KeyChoice(Runnable changed) {
        this.changed = changed;
    }

    public ReadOnlyObjectProperty<Set<KeyPlace>> keysProperty() {
        return keys.getReadOnlyProperty();
    }

    public Set<KeyPlace> keys() {
        return keys.get();
    }

    /** Chooses these, and no others. */
    public void set(Set<KeyPlace> v) {
        keys.set(Set.copyOf(v));
        changed.run();
    }

    /** Forgets those that are gone; returns how many are left. */
    int settled(AnimatedScene scene) {
        if (!keys.get().isEmpty()) {
            Set<KeyPlace> left = keys.get().stream().filter(k -> scene.shot().flatMap(s -> s.track(k.target(), k.attribute()))
                    .flatMap(t -> t.key(k.frame())).isPresent()).collect(Collectors.toUnmodifiableSet());
            if (!left.equals(keys.get())) {
                keys.set(left);
            }
        }
        return keys.get().size();
    }
}
