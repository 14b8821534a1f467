package lightning.scene.shot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.scene.Scene;
import lightning.scene.SceneElement;

/** Transfer of tracks to the objects of an edited scene. */
public final class TrackRetargeting {
    private final Scene after;
    /** Renamed objects. */
    private final Map<SceneElement<?>, SceneElement<?>> renamed = new HashMap<>();

    public TrackRetargeting(Scene before, Scene after) {
        this.after = after;
        Map<Class<?>, List<SceneElement<?>>> current = byType(after);
        byType(before).forEach((type, previous) -> matchRenamed(previous, current.getOrDefault(type, List.of())));
    }

    private static Map<Class<?>, List<SceneElement<?>>> byType(Scene scene) {
        return SceneElement.named(scene).collect(Collectors.groupingBy(Object::getClass));
    }

    private void matchRenamed(List<SceneElement<?>> previous, List<SceneElement<?>> current) {
        if (previous.equals(current)) {
            return;
        }
        Set<SceneElement<?>> unmatched = new LinkedHashSet<>(current);
        unmatched.removeAll(new HashSet<>(previous));
        Set<SceneElement<?>> retained = new HashSet<>(current);
        for (int i = 0; i < previous.size(); i++) {
            for (int index : new int[] {i, i + current.size() - previous.size()}) {
                if (!retained.contains(previous.get(i)) && index >= 0 && index < current.size() && unmatched.remove(current.get(index))) {
                    renamed.put(previous.get(i), current.get(index));
                    break;
                }
            }
        }
    }

    /** Returns the shot for the edited scene: without removed targets, and without keyframes that the new targets cannot have. */
    public Shot retarget(Shot shot) {
        List<Track> retargeted = new ArrayList<>();
        for (Track track : shot.tracks()) {
            retarget(track.target()).map(track::withTarget).filter(this::isValid).ifPresent(retargeted::add);
        }
        return retargeted.equals(shot.tracks()) ? shot : shot.withTracks(retargeted);
    }

    private boolean isValid(Track track) {
        return track.target().attributes(after).stream().anyMatch(a -> a.name().equals(track.attribute()));
    }

    /**
     * Returns the new target of the tracks of {@code old}: the object with its name; else the one at its index among objects of its kind,
     * counted from the front or the back, if its name is new. Empty if the object is gone.
     */
    public Optional<SceneElement<?>> retarget(SceneElement<?> old) {
        return old.existsIn(after) ? Optional.of(old) : Optional.ofNullable(renamed.get(old));
    }
}
