package lightning.editor.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.KeyframeSupport;
import lightning.scene.Scene;
import lightning.scene.SceneAttribute;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/** Edits of a shot's keys. Each throws an {@link IllegalArgumentException} where it leads to what no shot can be. */
public final class KeyEdits {
    /** What a new shot has: two seconds. */
    private static final Shot NEW_SHOT = new Shot(1, 48, 24, List.of());

    private KeyEdits() {}

    /** The scene with a shot that has no keys yet; one that has a shot keeps that. */
    public static AnimatedScene addShot(AnimatedScene scene) {
        return scene.shot().isPresent() ? scene : scene.withShot(NEW_SHOT);
    }

    /** Other frames and another rate. */
    public static AnimatedScene setFrames(AnimatedScene scene, int first, int last, double rate) {
        return scene.withShot(new Shot(first, last, rate, shot(scene).tracks()));
    }

    /** With a key that says of an attribute what it is now; the shot begins with it where there is none. */
    public static AnimatedScene setKey(AnimatedScene scene, Scene shownScene, TrackTarget target, String attribute, int frame) {
        AnimatedScene withShot = addShot(scene);
        SceneAttribute<?, ?> keyable = target.attribute(shownScene, attribute).<SceneAttribute<?, ?>>map(a -> a)
                .orElseThrow(() -> new IllegalArgumentException(Messages.tr("{0} has no keyframes", attribute)));
        var key = new Keyframe(frame, target.value(shownScene, attribute),
                keyable.kind().keyframeSupport() == KeyframeSupport.STEPPED ? Interpolation.STEPPED : Interpolation.LINEAR);
        Shot shot = shot(withShot);
        return withShot.withShot(shot.with(shot.track(target, attribute).map(t -> t.with(frame, key.value()))
                .orElseGet(() -> new Track(target, attribute, List.of(key)))));
    }

    /** Without the keys of an attribute, which is at all frames what it is now. */
    public static AnimatedScene removeKeys(AnimatedScene scene, Scene shownScene, TrackTarget target, String attribute) {
        return scene.withoutTrack(target, attribute, target.value(shownScene, attribute));
    }

    /** Without some keys; an attribute whose last key goes is at all frames what it is now. */
    public static AnimatedScene deleteKeys(AnimatedScene scene, Scene shownScene, Set<KeyId> deleted) {
        AnimatedScene remaining = scene;
        for (Track track : shot(scene).tracks()) {
            List<Keyframe> keys = track.keys().stream().filter(k -> !deleted.contains(KeyId.of(track, k))).toList();
            if (keys.isEmpty()) {
                remaining = removeKeys(remaining, shownScene, track.target(), track.attribute());
            } else if (keys.size() < track.keys().size()) {
                remaining = remaining.withShot(shot(remaining).with(new Track(track.target(), track.attribute(), keys)));
            }
        }
        return remaining;
    }

    /** Some keys some frames later, in place of those that they come upon. */
    public static AnimatedScene shiftKeys(AnimatedScene scene, Set<KeyId> moved, int frames) {
        return editKeys(scene, moved, key -> new Keyframe(Math.addExact(key.frame(), frames), key.value(), key.interpolation()));
    }

    /** How far keys can be moved back, and on. */
    public static int clampShift(Set<KeyId> moved, int frames) {
        int minFrame = moved.stream().mapToInt(KeyId::frame).min().orElse(0);
        int maxFrame = moved.stream().mapToInt(KeyId::frame).max().orElse(0);
        return Math.clamp(frames, -minFrame, Shot.MAX_FRAME - maxFrame);
    }

    /** Some keys that go on in another way; those of words and whole numbers stay stepped. */
    public static AnimatedScene setInterpolation(AnimatedScene scene, Set<KeyId> keys, Interpolation interpolation) {
        Set<KeyId> interpolated = new HashSet<>(keys);
        interpolated.removeIf(k -> k.target().attribute(scene.base(), k.attribute()).<SceneAttribute<?, ?>>map(a -> a)
                .filter(a -> a.kind().keyframeSupport() == KeyframeSupport.INTERPOLATED).isEmpty());
        return editKeys(scene, interpolated, key -> new Keyframe(key.frame(), key.value(), interpolation));
    }

    private static AnimatedScene editKeys(AnimatedScene scene, Set<KeyId> selected, Function<Keyframe, Keyframe> edit) {
        List<Track> tracks = new ArrayList<>();
        for (Track track : shot(scene).tracks()) {
            List<Keyframe> edited = track.keys().stream().filter(k -> selected.contains(KeyId.of(track, k))).map(edit).toList();
            if (edited.isEmpty()) {
                tracks.add(track);
                continue;
            }
            List<Keyframe> unchanged = track.keys().stream().filter(k -> !selected.contains(KeyId.of(track, k))).toList();
            Set<Integer> editedFrames = edited.stream().map(Keyframe::frame).collect(Collectors.toSet());
            tracks.add(new Track(track.target(), track.attribute(), Stream.concat(edited.stream(),
                    unchanged.stream().filter(k -> !editedFrames.contains(k.frame()))).sorted(Comparator.comparingInt(Keyframe::frame))
                    .toList()));
        }
        return scene.withShot(shot(scene).withTracks(tracks));
    }

    private static Shot shot(AnimatedScene scene) {
        return scene.shot().orElseThrow(() -> new IllegalArgumentException(Messages.tr("the scene has no shot")));
    }
}
