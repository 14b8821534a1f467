package lightning.scene.shot;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.value.SceneLimits;

/**
 * Animation of a scene by keyframes. Equal shots give the same scene at every frame.
 *
 * @param first  first frame, 0 … {@link #MAX_FRAME}
 * @param last   last frame, from {@code first}
 * @param rate   frames per second, {@value #MIN_RATE} … {@value #MAX_RATE}
 * @param tracks one for each animated attribute, grouped by target; at most {@value #MAX_KEYS} keyframes in all
 */
public record Shot(int first, int last, double rate, List<Track> tracks) {
    public static final int MAX_FRAME = 1_000_000_000;
    public static final int MAX_KEYS = 1_000_000;
    public static final double MIN_RATE = 0.001;
    public static final double MAX_RATE = 1000;
    /** One frame without keyframes, 24 frames per second. */
    public static final Shot DEFAULT = new Shot(1, 1, 24, List.of());

    public Shot {
        checkFrame("the first frame", first);
        SceneLimits.checkRange("the last frame", last, first, MAX_FRAME);
        SceneLimits.checkRange("rate", rate, MIN_RATE, MAX_RATE);
        Map<SceneElement<?>, List<Track>> byTarget = new LinkedHashMap<>();
        Set<String> seen = new HashSet<>();
        long keys = 0;
        for (Track track : tracks) {
            if (!seen.add(track.target() + "." + track.attribute())) {
                throw new RefusalException(track.target().label() + ": " + track.attribute() + " must have its keys once");
            }
            keys += track.keys().size();
            byTarget.computeIfAbsent(track.target(), _ -> new ArrayList<>()).add(track);
        }
        SceneLimits.checkRange("the number of keys", keys, 0, MAX_KEYS);
        tracks = byTarget.values().stream().flatMap(List::stream).toList();
    }

    static void checkFrame(String name, int frame) {
        SceneLimits.checkRange(name, frame, 0, MAX_FRAME);
    }

    /** Returns the keyframes of an attribute. */
    public Optional<Track> track(SceneElement<?> target, String attribute) {
        return tracks.stream().filter(t -> t.target().equals(target) && t.attribute().equals(attribute)).findFirst();
    }

    public Shot withTracks(List<Track> v) {
        return new Shot(first, last, rate, v);
    }

    public Shot withFrames(int newFirst, int newLast) {
        return new Shot(newFirst, newLast, rate, tracks);
    }

    /** Returns this shot with the track of one attribute added or replaced. */
    public Shot with(Track track) {
        List<Track> newTracks = new ArrayList<>(tracks);
        int index = -1;
        for (int i = 0; i < newTracks.size(); i++) {
            if (newTracks.get(i).target().equals(track.target()) && newTracks.get(i).attribute().equals(track.attribute())) {
                index = i;
            }
        }
        if (index < 0) {
            newTracks.add(track);
        } else {
            newTracks.set(index, track);
        }
        return withTracks(newTracks);
    }

    /**
     * Checks that the shot matches a scene.
     *
     * @throws IllegalArgumentException if a target is missing in the scene or lacks the attribute, or if the attribute may not have a
     *     keyframe's value
     */
    public void check(Scene scene) {
        tracks.forEach(track -> track.check(scene));
    }

    /**
     * Returns the scene at a frame, with the keyframes applied to {@code scene}. Shares its stage if no shape and no group is animated.
     *
     * @param scene a scene that passes {@link #check}
     * @param frame any frame, also fractional; before the first and after the last keyframe, their values hold
     * @throws IllegalArgumentException if the values are inconsistent there, for example if a camera is at its target; the message begins
     *     with the frame
     */
    public Scene sceneAt(Scene scene, double frame) {
        try {
            return new FrameEvaluator(tracks, frame).evaluate(scene);
        } catch (RefusalException e) {
            throw new RefusalException("frame " + new BigDecimal(frame).toPlainString() + ": " + e.getMessage(), e);
        }
    }
}
