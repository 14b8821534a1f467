package lightning.editor.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.Texts;
import lightning.scene.Attribute;
import lightning.scene.Keying;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/** Edits of a shot's keys. Each throws an {@link IllegalArgumentException} where it leads to what no shot can be. */
public final class KeyEdits {
    /** What a new shot has: two seconds. */
    private static final Shot NEW = new Shot(1, 48, 24, List.of());

    private KeyEdits() {}

    /** The scene with a shot that has no keys yet; one that has a shot keeps that. */
    public static AnimatedScene begin(AnimatedScene scene) {
        return scene.shot().isPresent() ? scene : scene.withShot(NEW);
    }

    /** Other frames and another rate. */
    public static AnimatedScene lasting(AnimatedScene scene, int first, int last, double rate) {
        return scene.withShot(new Shot(first, last, rate, shot(scene).tracks()));
    }

    /** With a key that says of an attribute what it is now; the shot begins with it where there is none. */
    public static AnimatedScene key(AnimatedScene scene, Scene shown, Target target, String attribute, int frame) {
        AnimatedScene begun = begin(scene);
        Attribute<?, ?> known = target.attribute(shown, attribute).<Attribute<?, ?>>map(a -> a)
                .orElseThrow(() -> new IllegalArgumentException(Texts.of("{0} has no keys", attribute)));
        var key = new Key(frame, target.setting(shown, attribute),
                known.kind().keying() == Keying.HOLDS ? Passage.STEPPED : Passage.LINEAR);
        Shot shot = shot(begun);
        return begun.withShot(shot.with(shot.track(target, attribute).map(t -> t.with(frame, key.setting()))
                .orElseGet(() -> new Track(target, attribute, List.of(key)))));
    }

    /** Without the keys of an attribute, which is at all frames what it is now. */
    public static AnimatedScene unkey(AnimatedScene scene, Scene shown, Target target, String attribute) {
        return scene.without(target, attribute, target.setting(shown, attribute));
    }

    /** Without some keys; an attribute whose last key goes is at all frames what it is now. */
    public static AnimatedScene without(AnimatedScene scene, Scene shown, Set<KeyPlace> gone) {
        AnimatedScene left = scene;
        for (Track track : shot(scene).tracks()) {
            List<Key> keys = track.keys().stream().filter(k -> !gone.contains(KeyPlace.of(track, k))).toList();
            if (keys.isEmpty()) {
                left = unkey(left, shown, track.target(), track.attribute());
            } else if (keys.size() < track.keys().size()) {
                left = left.withShot(shot(left).with(new Track(track.target(), track.attribute(), keys)));
            }
        }
        return left;
    }

    /** Some keys some frames later, in place of those that they come upon. */
    public static AnimatedScene later(AnimatedScene scene, Set<KeyPlace> moved, int frames) {
        return onKeys(scene, moved, key -> new Key(Math.addExact(key.frame(), frames), key.setting(), key.passage()));
    }

    /** How far keys can be moved back, and on. */
    public static int within(Set<KeyPlace> moved, int frames) {
        int least = moved.stream().mapToInt(KeyPlace::frame).min().orElse(0);
        int most = moved.stream().mapToInt(KeyPlace::frame).max().orElse(0);
        return Math.clamp(frames, -least, Shot.MAX_FRAME - most);
    }

    /** Some keys that go on in another way; those of words and whole numbers stay stepped. */
    public static AnimatedScene passing(AnimatedScene scene, Set<KeyPlace> keys, Passage passage) {
        Set<KeyPlace> gliding = new HashSet<>(keys);
        gliding.removeIf(k -> k.target().attribute(scene.still(), k.attribute()).<Attribute<?, ?>>map(a -> a)
                .filter(a -> a.kind().keying() == Keying.GLIDES).isEmpty());
        return onKeys(scene, gliding, key -> new Key(key.frame(), key.setting(), passage));
    }

    private static AnimatedScene onKeys(AnimatedScene scene, Set<KeyPlace> some, Function<Key, Key> edit) {
        List<Track> tracks = new ArrayList<>();
        for (Track track : shot(scene).tracks()) {
            List<Key> chosen = track.keys().stream().filter(k -> some.contains(KeyPlace.of(track, k))).map(edit).toList();
            if (chosen.isEmpty()) {
                tracks.add(track);
                continue;
            }
            List<Key> rest = track.keys().stream().filter(k -> !some.contains(KeyPlace.of(track, k))).toList();
            Set<Integer> taken = chosen.stream().map(Key::frame).collect(Collectors.toSet());
            tracks.add(new Track(track.target(), track.attribute(), Stream.concat(chosen.stream(),
                    rest.stream().filter(k -> !taken.contains(k.frame()))).sorted(Comparator.comparingInt(Key::frame)).toList()));
        }
        return scene.withShot(shot(scene).withTracks(tracks));
    }

    private static Shot shot(AnimatedScene scene) {
        return scene.shot().orElseThrow(() -> new IllegalArgumentException(Texts.of("the scene has no shot")));
    }
}
