package lightning.scene.shot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;

/** Transfer of tracks to the objects of an edited scene. */
public final class TrackRetargeting {
    private final Scene after;
    /** Renamed objects. */
    private final Map<TrackTarget, TrackTarget> renamed = new HashMap<>();

    public TrackRetargeting(Scene before, Scene after) {
        this.after = after;
        for (TrackTarget.Kind kind : TrackTarget.Kind.values()) {
            matchRenamed(kind, names(before, kind), names(after, kind));
        }
    }

    private void matchRenamed(TrackTarget.Kind kind, List<String> oldNames, List<String> newNames) {
        if (oldNames.equals(newNames)) {
            return;
        }
        Set<String> unmatched = new LinkedHashSet<>(newNames);
        unmatched.removeAll(new HashSet<>(oldNames));
        Set<String> retained = new HashSet<>(newNames);
        for (int i = 0; i < oldNames.size(); i++) {
            for (int index : new int[] {i, i + newNames.size() - oldNames.size()}) {
                if (!retained.contains(oldNames.get(i)) && index >= 0 && index < newNames.size() && unmatched.remove(newNames.get(index))) {
                    renamed.put(new TrackTarget(kind, oldNames.get(i)), new TrackTarget(kind, newNames.get(index)));
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
    public Optional<TrackTarget> retarget(TrackTarget old) {
        return old.existsIn(after) ? Optional.of(old) : Optional.ofNullable(renamed.get(old));
    }

    private static List<String> names(Scene scene, TrackTarget.Kind kind) {
        return switch (kind) {
            case CAMERA -> List.of("");
            case LIGHT -> scene.lights().stream().map(Light::name).toList();
            case LIGHT_GROUP -> scene.rig().lightGroups().stream().map(LightGroup::name).toList();
            case DOME -> scene.world().named().stream().map(Dome::name).toList();
            case NODE -> scene.nodes().stream().flatMap(TrackRetargeting::names).toList();
        };
    }

    private static Stream<String> names(SceneNode node) {
        return Stream.concat(Stream.of(node.name()),
                node instanceof NodeGroup g ? g.children().stream().flatMap(TrackRetargeting::names) : Stream.empty());
    }
}
