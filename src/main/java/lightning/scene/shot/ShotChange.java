package lightning.scene.shot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.text.Quote;
import lightning.base.text.Texts;
import lightning.scene.Attribute;
import lightning.scene.Scene;
import lightning.scene.SceneChange;

/** Says what changed of a scene and its keys in one line for a menu: {@code key: intensity at frame 12}. */
public final class ShotChange {
    /** Of more attributes than this it is not told whose keys changed. */
    private static final int MOST = 3;

    private final Scene scene;
    private final List<String> parts = new ArrayList<>();

    private ShotChange(Scene scene) {
        this.scene = scene;
    }

    /** Never empty. */
    public static String summary(AnimatedScene before, AnimatedScene after) {
        var change = new ShotChange(after.still());
        if (!before.still().equals(after.still()) || before.shot().equals(after.shot())) {
            change.parts.add(SceneChange.summary(before.still(), after.still()));
        }
        // What is renamed, and what goes with a light, is no news of the keys.
        Optional<Shot> was = before.still().equals(after.still()) ? before.shot() : before.with(after.still()).shot();
        if (after.shot().isEmpty() && was.isPresent()) {
            change.parts.add(Texts.of("delete the shot"));
        } else if (after.shot().isPresent()) {
            if (was.isEmpty()) {
                change.parts.add(Texts.of("new shot"));
            }
            change.of(was.orElse(after.shot().get().withTracks(List.of())), after.shot().get());
        }
        return String.join(", ", change.parts);
    }

    /** The same of the keys of one thing alone; empty where they are the same. */
    public static String summary(Scene scene, List<Track> before, List<Track> after) {
        var change = new ShotChange(scene);
        change.of(Shot.DEFAULT.withTracks(before), Shot.DEFAULT.withTracks(after));
        return String.join(", ", change.parts);
    }

    private void of(Shot before, Shot after) {
        if (before.first() != after.first() || before.last() != after.last()) {
            parts.add(Texts.of("frames {0} to {1}", after.first(), after.last()));
        }
        if (before.rate() != after.rate()) {
            parts.add(Texts.of("frames per second"));
        }
        Map<String, Track> old = new LinkedHashMap<>();
        before.tracks().forEach(t -> old.put(t.target() + "." + t.attribute(), t));
        Map<String, Track> now = new LinkedHashMap<>();
        after.tracks().forEach(t -> now.put(t.target() + "." + t.attribute(), t));
        Set<String> all = new LinkedHashSet<>(old.keySet());
        all.addAll(now.keySet());
        List<String> told = all.stream().filter(n -> !Optional.ofNullable(old.get(n)).equals(Optional.ofNullable(now.get(n))))
                .map(n -> text(old.get(n), now.get(n))).toList();
        parts.addAll(told.size() <= MOST ? told : List.of(Texts.of("keys of {0} attributes", told.size())));
    }

    /** @param before null where there was none; likewise {@code after} */
    private String text(Track before, Track after) {
        Track track = after == null ? before : after;
        String title = name(track.target()) + ": " + title(track);
        List<Key> came = new ArrayList<>(after == null ? List.of() : after.keys());
        List<Key> gone = new ArrayList<>(before == null ? List.of() : before.keys());
        if (before != null && after != null) {
            came.removeAll(before.keys());
            gone.removeAll(after.keys());
        }
        if (came.size() == 1 && gone.stream().allMatch(k -> k.frame() == came.getFirst().frame())) {
            return Texts.of("{0} at frame {1}", title, came.getFirst().frame());
        }
        if (came.isEmpty() && gone.size() == 1) {
            return Texts.of("{0} without key at frame {1}", title, gone.getFirst().frame());
        }
        return Texts.of("{0}: keys", title);
    }

    /** As lists call what has keys. */
    public static String name(Target target) {
        return target.what() == Target.What.CAMERA ? Texts.of("camera") : Quote.path(target.name());
    }

    private String title(Track track) {
        String name = track.attribute();
        return Texts.of(track.target().isIn(scene)
                ? track.target().attribute(scene, name).<Attribute<?, ?>>map(a -> a).map(Attribute::title).orElse(name) : name);
    }
}
