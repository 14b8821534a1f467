package lightning.editor.window.model;

import java.util.Set;
import java.util.stream.Collectors;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import lightning.document.KeyId;
import lightning.scene.shot.AnimatedScene;

/** Selected keyframes of the shot, which keyframe commands act on. */
public final class KeySelection {
    private final ReadOnlyObjectWrapper<Set<KeyId>> keys = new ReadOnlyObjectWrapper<>(Set.of());
    private final Runnable changeListener;

    KeySelection(Runnable changeListener) {
        this.changeListener = changeListener;
    }

    public ReadOnlyObjectProperty<Set<KeyId>> keysProperty() {
        return keys.getReadOnlyProperty();
    }

    public Set<KeyId> keys() {
        return keys.get();
    }

    /** Replaces the selection. */
    public void set(Set<KeyId> v) {
        keys.set(Set.copyOf(v));
        changeListener.run();
    }

    /** Deselects keyframes that no longer exist. Returns the number of selected keyframes. */
    int retainExisting(AnimatedScene scene) {
        if (!keys.get().isEmpty()) {
            Set<KeyId> remaining = keys.get().stream().filter(k -> scene.shot().flatMap(s -> s.track(k.target(), k.attribute()))
                    .flatMap(t -> t.key(k.frame())).isPresent()).collect(Collectors.toUnmodifiableSet());
            if (!remaining.equals(keys.get())) {
                keys.set(remaining);
            }
        }
        return keys.get().size();
    }
}
