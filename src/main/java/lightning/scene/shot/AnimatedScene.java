package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Scene;

/**
 * A scene with its shot: an ordinary scene at each frame, any of which can be edited.
 *
 * @param base the scene as it is where nothing has keys
 * @param shot  keys over frames; empty where the scene does not move
 */
public record AnimatedScene(Scene base, Optional<Shot> shot) {

    /** One that does not move. */
    public static AnimatedScene of(Scene base) {
        return new AnimatedScene(base, Optional.empty());
    }

    /** The scene with another shot, unless it is one of another scene: see {@link Shot#check}. */
    public AnimatedScene withShot(Shot newShot) {
        newShot.check(base);
        return new AnimatedScene(base, Optional.of(newShot));
    }

    /** Without the keys of an attribute, which is at all frames as a key would say it; the same where it has none. */
    public AnimatedScene withoutTrack(TrackTarget target, String attribute, KeyframeValue value) {
        if (shot.flatMap(s -> s.track(target, attribute)).isEmpty()) {
            return this;
        }
        var constant = new Track(target, attribute, List.of(new Keyframe(0, value, Interpolation.STEPPED)));
        List<Track> remaining =
                shot.get().tracks().stream().filter(t -> !t.target().equals(target) || !t.attribute().equals(attribute)).toList();
        return new AnimatedScene(new FrameEvaluator(List.of(constant), 0).evaluate(base), Optional.of(shot.get().withTracks(remaining)));
    }

    /** Another scene, whose things have the keys of what they come from. */
    public AnimatedScene withScene(Scene newBase) {
        return new AnimatedScene(newBase, shot.map(s -> new TrackRetargeting(base, newBase).retarget(s)));
    }

    /**
     * The scene at a frame.
     *
     * @throws IllegalArgumentException as {@link Shot#sceneAt}
     */
    public Scene sceneAt(int frame) {
        return shot.map(s -> s.sceneAt(base, frame)).orElse(base);
    }

    /**
     * What an edit at a frame makes of it: what has keys and was changed has a key there, which goes on to the next as the key before
     * it; all else is another at every frame. At that frame it is the edited scene.
     *
     * @param shown  the scene at that frame
     * @param edited what {@code shown} was made to be
     * @throws IllegalArgumentException if the scene cannot be so where nothing has keys, as a camera that stands where it looks
     */
    public AnimatedScene withEdit(int frame, Scene shown, Scene edited) {
        if (shot.isEmpty()) {
            return of(edited);
        }
        var retargeting = new TrackRetargeting(shown, edited);
        // Most edits leave shapes alone: the stage of all frames is then kept, and nobody looks at its shapes.
        boolean sameNodes = edited.stage().hasSameNodes(shown.stage());
        Shot newShot = retargeting.retarget(shot.get());
        List<Track> baseTracks = new ArrayList<>();
        for (Track track : shot.get().tracks()) {
            TrackTarget target = retargeting.retarget(track.target()).orElse(null);
            if (target == null || target.attribute(edited, track.attribute()).isEmpty()) {
                continue;
            }
            KeyframeValue value = target.value(edited, track.attribute());
            if (!value.equals(track.target().value(shown, track.attribute()))) {
                newShot = newShot.with(track.withTarget(target).with(frame, value));
            }
            if (target.kind() != TrackTarget.Kind.NODE || !sameNodes) {
                baseTracks.add(new Track(target, track.attribute(),
                        List.of(new Keyframe(0, track.target().value(base, track.attribute()), Interpolation.STEPPED))));
            }
        }
        Scene template = sameNodes ? edited.withStage(base.stage().withMaterials(edited.materials())) : edited;
        return new AnimatedScene(new FrameEvaluator(baseTracks, 0).evaluate(template), Optional.of(newShot));
    }
}
