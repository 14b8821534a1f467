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
import lightning.scene.Bank;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.Node;
import lightning.scene.Scene;

/** Which thing of an edited scene has the keys of one before the edit. */
public final class ShotSuccession {
    private final Scene after;
    /** Those that have another name now. */
    private final Map<Target, Target> renamed = new HashMap<>();

    public ShotSuccession(Scene before, Scene after) {
        this.after = after;
        for (Target.What what : Target.What.values()) {
            rename(what, names(before, what), names(after, what));
        }
    }

    private void rename(Target.What what, List<String> were, List<String> are) {
        if (were.equals(are)) {
            return;
        }
        Set<String> left = new LinkedHashSet<>(are);
        left.removeAll(new HashSet<>(were));
        Set<String> kept = new HashSet<>(are);
        for (int i = 0; i < were.size(); i++) {
            for (int place : new int[] {i, i + are.size() - were.size()}) {
                if (!kept.contains(were.get(i)) && place >= 0 && place < are.size() && left.remove(are.get(place))) {
                    renamed.put(new Target(what, were.get(i)), new Target(what, are.get(place)));
                    break;
                }
            }
        }
    }

    /** The shot of the edited scene: without what is gone, and without keys that what is there now cannot have. */
    public Shot of(Shot shot) {
        List<Track> kept = new ArrayList<>();
        for (Track track : shot.tracks()) {
            of(track.target()).map(track::of).filter(this::fits).ifPresent(kept::add);
        }
        return kept.equals(shot.tracks()) ? shot : shot.withTracks(kept);
    }

    private boolean fits(Track track) {
        return track.target().attributes(after).stream().anyMatch(a -> a.name().equals(track.attribute()));
    }

    /**
     * What has the keys of {@code old} now: what has its name, or else what stands at its place among those of its kind, from the
     * front or from the back, under a name that was not there. Nothing where it is gone.
     */
    public Optional<Target> of(Target old) {
        return old.isIn(after) ? Optional.of(old) : Optional.ofNullable(renamed.get(old));
    }

    private static List<String> names(Scene scene, Target.What what) {
        return switch (what) {
            case CAMERA -> List.of("");
            case LIGHT -> scene.lights().stream().map(Light::name).toList();
            case BANK -> scene.rig().banks().stream().map(Bank::name).toList();
            case NODE -> scene.nodes().stream().flatMap(ShotSuccession::names).toList();
        };
    }

    private static Stream<String> names(Node node) {
        return Stream.concat(Stream.of(node.name()),
                node instanceof Group g ? g.children().stream().flatMap(ShotSuccession::names) : Stream.empty());
    }
}
