package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.SceneElement;

/**
 * Scene with an optional shot: an ordinary, editable scene at each frame.
 *
 * @param base scene without keyframes applied
 * @param shot keyframes; empty for a still scene
 */
public record AnimatedScene(Scene base, Optional<Shot> shot) {

    /** Returns a still scene. */
    public static AnimatedScene of(Scene base) {
        return new AnimatedScene(base, Optional.empty());
    }

    /** Returns the scene with another shot, which must match the scene: see {@link Shot#check}. */
    public AnimatedScene withShot(Shot newShot) {
        newShot.check(base);
        return new AnimatedScene(base, Optional.of(newShot));
    }

    /**
     * Returns the scene without the keyframes of an attribute, which has the given value at all frames; the same if it has no keyframes.
     */
    public AnimatedScene withoutTrack(SceneElement<?> target, String attribute, KeyframeValue value) {
        if (shot.flatMap(s -> s.track(target, attribute)).isEmpty()) {
            return this;
        }
        var constant = new Track(target, attribute, List.of(new Keyframe(0, value, Interpolation.STEPPED)));
        List<Track> remaining =
                shot.get().tracks().stream().filter(t -> !t.target().equals(target) || !t.attribute().equals(attribute)).toList();
        return new AnimatedScene(new FrameEvaluator(List.of(constant), 0).evaluate(base), Optional.of(shot.get().withTracks(remaining)));
    }

    /** Returns another scene with the keyframes transferred to the objects that come from those of this one. */
    public AnimatedScene withScene(Scene newBase) {
        return new AnimatedScene(newBase, shot.map(s -> new TrackRetargeting(base, newBase).retarget(s)));
    }

    /**
     * Returns the scene at a frame.
     *
     * @throws IllegalArgumentException as {@link Shot#sceneAt}
     */
    public Scene sceneAt(int frame) {
        return shot.map(s -> s.sceneAt(base, frame)).orElse(base);
    }

    /**
     * Applies an edit made at a frame. Animated attributes get a keyframe there, with the interpolation of the one before it; other changes
     * apply at every frame. At that frame the result equals the edited scene.
     *
     * @param shown  scene at that frame
     * @param edited edited version of {@code shown}
     * @throws IllegalArgumentException if the scene is invalid without keyframes, for example if a camera is at its target
     */
    public AnimatedScene withEdit(int frame, Scene shown, Scene edited) {
        if (shot.isEmpty()) {
            return of(edited);
        }
        var retargeting = new TrackRetargeting(shown, edited);
        // Most edits do not change shapes: then shares the stage of all frames and compares no shapes.
        boolean sameNodes = edited.stage().hasSameNodes(shown.stage());
        Shot newShot = retargeting.retarget(shot.get());
        List<Track> baseTracks = new ArrayList<>();
        for (Track track : shot.get().tracks()) {
            SceneElement<?> target = retargeting.retarget(track.target()).orElse(null);
            if (target == null || target.attribute(edited, track.attribute()).isEmpty()) {
                continue;
            }
            KeyframeValue value = KeyframeValue.of(edited, target, track.attribute());
            if (!value.equals(KeyframeValue.of(shown, track.target(), track.attribute()))) {
                newShot = newShot.with(track.withTarget(target).with(frame, value));
            }
            if (!(target instanceof SceneElement.OfNode) || !sameNodes) {
                baseTracks.add(new Track(target, track.attribute(),
                        List.of(new Keyframe(0, KeyframeValue.of(base, track.target(), track.attribute()), Interpolation.STEPPED))));
            }
        }
        Scene template = sameNodes ? edited.withStage(base.stage().withMaterials(edited.materials())) : edited;
        return new AnimatedScene(new FrameEvaluator(baseTracks, 0).evaluate(template), Optional.of(newShot));
    }
}
