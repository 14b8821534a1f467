package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.Scene;

/**
 * A scene with its shot: an ordinary scene at each frame, any of which can be edited.
 *
 * @param still the scene as it is where nothing has keys
 * @param shot  keys over frames; empty where the scene does not move
 */
public record AnimatedScene(Scene still, Optional<Shot> shot) {

    /** One that does not move. */
    public static AnimatedScene of(Scene still) {
        return new AnimatedScene(still, Optional.empty());
    }

    /** The scene with another shot, unless it is one of another scene: see {@link Shot#check}. */
    public AnimatedScene withShot(Shot other) {
        other.check(still);
        return new AnimatedScene(still, Optional.of(other));
    }

    /** Without the keys of an attribute, which is at all frames as a key would say it; the same where it has none. */
    public AnimatedScene without(Target target, String attribute, Setting setting) {
        if (shot.flatMap(s -> s.track(target, attribute)).isEmpty()) {
            return this;
        }
        var last = new Track(target, attribute, List.of(new Key(0, setting, Passage.STEPPED)));
        List<Track> left =
                shot.get().tracks().stream().filter(t -> !t.target().equals(target) || !t.attribute().equals(attribute)).toList();
        return new AnimatedScene(new FrameScene(List.of(last), 0).of(still), Optional.of(shot.get().withTracks(left)));
    }

    /** Another scene, whose things have the keys of what they come from. */
    public AnimatedScene with(Scene other) {
        return new AnimatedScene(other, shot.map(s -> new ShotSuccession(still, other).of(s)));
    }

    /**
     * The scene at a frame.
     *
     * @throws IllegalArgumentException as {@link Shot#at}
     */
    public Scene at(int frame) {
        return shot.map(s -> s.at(still, frame)).orElse(still);
    }

    /**
     * What an edit at a frame makes of it: what has keys and was changed has a key there, which goes on to the next as the key before
     * it; all else is another at every frame. At that frame it is the edited scene.
     *
     * @param shown  the scene at that frame
     * @param edited what {@code shown} was made to be
     * @throws IllegalArgumentException if the scene cannot be so where nothing has keys, as a camera that stands where it looks
     */
    public AnimatedScene edited(int frame, Scene shown, Scene edited) {
        if (shot.isEmpty()) {
            return of(edited);
        }
        var succession = new ShotSuccession(shown, edited);
        // Most edits leave shapes alone: the stage of all frames is then kept, and nobody looks at its shapes.
        boolean sameNodes = edited.stage().hasNodesOf(shown.stage());
        Shot keyed = succession.of(shot.get());
        List<Track> restored = new ArrayList<>();
        for (Track track : shot.get().tracks()) {
            Target now = succession.of(track.target()).orElse(null);
            if (now == null || now.attribute(edited, track.attribute()).isEmpty()) {
                continue;
            }
            Setting setting = now.setting(edited, track.attribute());
            if (!setting.equals(track.target().setting(shown, track.attribute()))) {
                keyed = keyed.with(track.of(now).with(frame, setting));
            }
            if (now.what() != Target.What.NODE || !sameNodes) {
                restored.add(new Track(now, track.attribute(),
                        List.of(new Key(0, track.target().setting(still, track.attribute()), Passage.STEPPED))));
            }
        }
        Scene base = sameNodes ? edited.withStage(still.stage().withMaterials(edited.materials())) : edited;
        return new AnimatedScene(new FrameScene(restored, 0).of(base), Optional.of(keyed));
    }
}
