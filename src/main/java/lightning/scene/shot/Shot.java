package lightning.scene.shot;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import lightning.scene.Scene;
import lightning.scene.SceneLimits;

/**
 * Keys over frames. Two equal shots give the same scene at every frame.
 *
 * @param first  the first frame, 0 … {@link #MAX_FRAME}
 * @param last   the last frame, from {@code first}
 * @param rate   frames per second, {@value #MIN_RATE} … {@value #MAX_RATE}
 * @param tracks one for each attribute that has keys, those of one target together; at most {@value #MAX_KEYS} keys in all
 */
public record Shot(int first, int last, double rate, List<Track> tracks) {
    public static final int MAX_FRAME = 1_000_000_000;
    public static final int MAX_KEYS = 1_000_000;
    public static final double MIN_RATE = 0.001;
    public static final double MAX_RATE = 1000;
    /** One frame of nothing, 24 in a second. */
    public static final Shot DEFAULT = new Shot(1, 1, 24, List.of());

    public Shot {
        checkFrame("the first frame", first);
        SceneLimits.checkRange("the last frame", last, first, MAX_FRAME);
        SceneLimits.checkRange("rate", rate, MIN_RATE, MAX_RATE);
        Map<TrackTarget, List<Track>> byTarget = new LinkedHashMap<>();
        Set<String> seen = new HashSet<>();
        long keys = 0;
        for (Track track : tracks) {
            if (!seen.add(track.target() + "." + track.attribute())) {
                throw new IllegalArgumentException(track.target() + ": " + track.attribute() + " must have its keys once");
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

    /** The keys of an attribute. */
    public Optional<Track> track(TrackTarget target, String attribute) {
        return tracks.stream().filter(t -> t.target().equals(target) && t.attribute().equals(attribute)).findFirst();
    }

    public Shot withTracks(List<Track> v) {
        return new Shot(first, last, rate, v);
    }

    public Shot withFrames(int newFirst, int newLast) {
        return new Shot(newFirst, newLast, rate, tracks);
    }

    /** This shot with other keys of one attribute, or with its first. */
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
     * Refuses a shot of another scene.
     *
     * @throws IllegalArgumentException if something with keys is not in the scene or lacks the attribute, or if the attribute may not
     *                                  have a key's value
     */
    public void check(Scene scene) {
        tracks.forEach(track -> track.check(scene));
    }

    /**
     * The scene at a frame: what has keys is as these say, all else as in {@code scene}, whose stage it shares where no shape and no
     * group has keys.
     *
     * @param scene one that {@link #check} takes
     * @param frame any, also between two frames; before the first key and behind the last one things are as these say
     * @throws IllegalArgumentException if what the keys say does not go together there, as a camera that stands where it looks; the
     *                                  message begins with the frame
     */
    public Scene sceneAt(Scene scene, double frame) {
        try {
            return new FrameEvaluator(tracks, frame).evaluate(scene);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("frame " + new BigDecimal(frame).toPlainString() + ": " + e.getMessage(), e);
        }
    }
}
