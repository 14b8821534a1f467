package lightning.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;

/** Edits of a shot's keyframes. Each throws an {@link IllegalArgumentException} if the result is not a valid shot. */
public final class KeyEdits {
    /** New shots have two seconds. */
    private static final Shot NEW_SHOT = new Shot(1, 48, 24, List.of());

    private KeyEdits() {}

    /** Adds a shot without keyframes; keeps an existing shot. */
    public static AnimatedScene addShot(AnimatedScene scene) {
        return scene.shot().isPresent() ? scene : scene.withShot(NEW_SHOT);
    }

    /** Changes the frame range and rate. */
    public static AnimatedScene setFrames(AnimatedScene scene, int first, int last, double rate) {
        return scene.withShot(new Shot(first, last, rate, shot(scene).tracks()));
    }

    /** Sets a keyframe of an attribute to its current value; adds a shot starting with it if there is none. */
    public static AnimatedScene setKey(AnimatedScene scene, Scene shownScene, SceneElement<?> target, String attribute, int frame) {
        AnimatedScene withShot = addShot(scene);
        SceneAttribute<?, ?> keyable = target.attribute(shownScene, attribute)
                .orElseThrow(() -> new RefusalException(Messages.tr("{0} has no keyframes", attribute)));
        var key = new Keyframe(frame, KeyframeValue.of(shownScene, target, attribute),
                keyable.kind().keyframeSupport() == KeyframeSupport.STEPPED ? Interpolation.STEPPED : Interpolation.LINEAR);
        Shot shot = shot(withShot);
        return withShot.withShot(shot.with(shot.track(target, attribute).map(t -> t.with(frame, key.value()))
                .orElseGet(() -> new Track(target, attribute, List.of(key)))));
    }

    /** Removes all keyframes of an attribute, which keeps its current value. */
    public static AnimatedScene removeKeys(AnimatedScene scene, Scene shownScene, SceneElement<?> target, String attribute) {
        return scene.withoutTrack(target, attribute, KeyframeValue.of(shownScene, target, attribute));
    }

    /** Deletes keyframes; an attribute without any left keeps its current value. */
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

    /** Moves keyframes by some frames, replacing those at the new frames. */
    public static AnimatedScene shiftKeys(AnimatedScene scene, Set<KeyId> moved, int frames) {
        return editKeys(scene, moved, key -> new Keyframe(Math.addExact(key.frame(), frames), key.value(), key.interpolation()));
    }

    /** Clamps a move of keyframes to the frames of the shot. */
    public static int clampShift(Set<KeyId> moved, int frames) {
        int minFrame = moved.stream().mapToInt(KeyId::frame).min().orElse(0);
        int maxFrame = moved.stream().mapToInt(KeyId::frame).max().orElse(0);
        return Math.clamp(frames, -minFrame, Shot.MAX_FRAME - maxFrame);
    }

    /** Sets the interpolation of keyframes; those of words and whole numbers stay stepped. */
    public static AnimatedScene setInterpolation(AnimatedScene scene, Set<KeyId> keys, Interpolation interpolation) {
        Set<KeyId> interpolated = new HashSet<>(keys);
        interpolated.removeIf(k -> k.target().attribute(scene.base(), k.attribute())
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
        return scene.shot().orElseThrow(() -> new RefusalException(Messages.tr("the scene has no shot")));
    }
}
