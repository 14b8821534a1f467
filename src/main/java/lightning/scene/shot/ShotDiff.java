package lightning.scene.shot;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.scene.Scene;
import lightning.scene.SceneDiff;
import lightning.scene.SceneElement;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/** One-line summary of the changes of a scene and its keyframes: {@code key: intensity at frame 12}. */
public final class ShotDiff {
    /** Above this many attributes, changed keyframes are not described. */
    private static final int MAX_ATTRIBUTES = 3;

    private final Scene scene;
    private final List<String> parts = new ArrayList<>();

    private ShotDiff(Scene scene) {
        this.scene = scene;
    }

    /** Summarizes all changes; never empty. */
    public static String summarize(AnimatedScene before, AnimatedScene after) {
        var change = new ShotDiff(after.base());
        if (!before.base().equals(after.base()) || before.shot().equals(after.shot())) {
            change.parts.add(SceneDiff.summarize(before.base(), after.base()));
        }
        // Renaming, or removing a track with its light, is not a change of keyframes.
        Optional<Shot> previous = before.base().equals(after.base()) ? before.shot() : before.withScene(after.base()).shot();
        if (after.shot().isEmpty() && previous.isPresent()) {
            change.parts.add(Messages.tr("delete the shot"));
        } else if (after.shot().isPresent()) {
            if (previous.isEmpty()) {
                change.parts.add(Messages.tr("new shot"));
            }
            change.addChanges(previous.orElse(after.shot().get().withTracks(List.of())), after.shot().get());
        }
        return String.join(", ", change.parts);
    }

    /** Summarizes the changed keyframes of one object; empty if unchanged. */
    public static String summarize(Scene scene, List<Track> before, List<Track> after) {
        var change = new ShotDiff(scene);
        change.addChanges(Shot.DEFAULT.withTracks(before), Shot.DEFAULT.withTracks(after));
        return String.join(", ", change.parts);
    }

    private void addChanges(Shot before, Shot after) {
        if (before.first() != after.first() || before.last() != after.last()) {
            parts.add(Messages.tr("frames {0} to {1}", after.first(), after.last()));
        }
        if (before.rate() != after.rate()) {
            parts.add(Messages.tr("frames per second"));
        }
        Map<String, Track> previous = new LinkedHashMap<>();
        before.tracks().forEach(t -> previous.put(t.target() + "." + t.attribute(), t));
        Map<String, Track> current = new LinkedHashMap<>();
        after.tracks().forEach(t -> current.put(t.target() + "." + t.attribute(), t));
        Set<String> allNames = new LinkedHashSet<>(previous.keySet());
        allNames.addAll(current.keySet());
        List<String> descriptions =
                allNames.stream().filter(n -> !Optional.ofNullable(previous.get(n)).equals(Optional.ofNullable(current.get(n))))
                        .map(n -> text(previous.get(n), current.get(n))).toList();
        parts.addAll(
                descriptions.size() <= MAX_ATTRIBUTES ? descriptions
                        : List.of(Messages.tr("keyframes of {0} attributes", descriptions.size())));
    }

    /**
     * @param before the old track
     * @param after  the new track
     */
    private String text(@Nullable Track before, @Nullable Track after) {
        Track track = after == null ? requireNonNull(before) : after;
        String title = name(track.target()) + ": " + title(track);
        List<Keyframe> added = new ArrayList<>(after == null ? List.of() : after.keys());
        List<Keyframe> removed = new ArrayList<>(before == null ? List.of() : before.keys());
        if (before != null && after != null) {
            added.removeAll(before.keys());
            removed.removeAll(after.keys());
        }
        if (added.size() == 1 && removed.stream().allMatch(k -> k.frame() == added.getFirst().frame())) {
            return Messages.tr("{0} at frame {1}", title, added.getFirst().frame());
        }
        if (added.isEmpty() && removed.size() == 1) {
            return Messages.tr("{0}: keyframe deleted at frame {1}", title, removed.getFirst().frame());
        }
        return Messages.tr("{0}: keyframes", title);
    }

    /** Returns a target's name in lists. */
    public static String name(SceneElement<?> target) {
        return switch (target) {
            case SceneElement.OfCamera _ -> Messages.tr("camera");
            case SceneElement.OfWorld _ -> Messages.tr("world");
            default -> Quote.path(target.name());
        };
    }

    private String title(Track track) {
        String name = track.attribute();
        return Messages.tr(track.target().existsIn(scene)
                ? track.target().attribute(scene, name).map(SceneAttribute::title).orElse(name) : name);
    }
}
