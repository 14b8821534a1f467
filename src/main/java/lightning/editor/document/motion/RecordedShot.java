package lightning.editor.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Limits;
import lightning.scene.shot.Key;
import lightning.scene.shot.Passage;
import lightning.scene.shot.Setting;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Target;
import lightning.scene.shot.Track;

/**
 * A shot of one light that was moved in the preview (paper §3.7): a linear key of its position and of its direction every
 * so many frames.
 *
 * @param every frames from one key to the next, 1…{@value #MAX_EVERY}
 * @param shot  from frame 0 to the last key; its tracks are the position and the direction, with keys at the same frames
 */
public record RecordedShot(int every, Shot shot) {
    public static final int DEFAULT_EVERY = 10;
    public static final int MAX_EVERY = 10_000;
    public static final int MAX_KEYS = 100_000;

    public RecordedShot {
        Limits.range("every", every, 1, MAX_EVERY);
        Limits.range("the number of keys", shot.tracks().getFirst().keys().size(), 1, MAX_KEYS);
    }

    /** @param samples the light at each key, at least one */
    static RecordedShot of(int every, List<Light> samples) {
        return ofTracks(every, List.of(track(LightAttribute.POSITION, every, samples), track(LightAttribute.DIRECTION, every, samples)));
    }

    private static Track track(LightAttribute<Vec3> attribute, int every, List<Light> samples) {
        List<Key> keys = new ArrayList<>();
        for (Light sample : samples) {
            Vec3 v = attribute.of(sample);
            keys.add(new Key(keys.size() * every, new Setting.Numbers(List.of(v.x(), v.y(), v.z())), Passage.LINEAR));
        }
        return new Track(Target.light(samples.getFirst().name()), attribute.name(), keys);
    }

    private static RecordedShot ofTracks(int every, List<Track> tracks) {
        return new RecordedShot(every, new Shot(0, tracks.getFirst().keys().getLast().frame(), Shot.DEFAULT.rate(), tracks));
    }

    /**
     * Returns a light's movement in a shot, its first key at frame 0. Empty if the light's position and direction do not have
     * linear keys at the same, evenly spaced frames.
     */
    public static Optional<RecordedShot> of(Shot shot, String light) {
        List<Track> tracks = Stream.of(LightAttribute.POSITION, LightAttribute.DIRECTION)
                .flatMap(a -> shot.track(Target.light(light), a.name()).stream()).toList();
        if (tracks.size() < 2 || tracks.getFirst().keys().size() > MAX_KEYS) {
            return Optional.empty();
        }
        List<Key> keys = tracks.getFirst().keys();
        int first = keys.getFirst().frame();
        int every = keys.size() == 1 ? DEFAULT_EVERY : keys.get(1).frame() - first;
        boolean isEven = every <= MAX_EVERY && tracks.stream().allMatch(t -> isEven(t, first, every, keys.size()));
        return isEven ? Optional.of(ofTracks(every, tracks.stream().map(t -> t.later(-first)).toList())) : Optional.empty();
    }

    private static boolean isEven(Track track, int first, int every, int size) {
        for (int i = 0; i < track.keys().size(); i++) {
            Key key = track.keys().get(i);
            if (key.frame() != first + (long) i * every || key.passage() != Passage.LINEAR) {
                return false;
            }
        }
        return track.keys().size() == size;
    }

    /**
     * Returns another shot in which the light moves like this from a frame on. Replaces the keys that its position and direction
     * had there. The shot gets longer where it ends before the last key.
     *
     * @throws IllegalArgumentException if a key would be after {@link Shot#MAX_FRAME}, or if there were too many
     */
    public Shot addTo(Shot other, int frame) {
        Shot all = other;
        for (Track track : shot.tracks()) {
            all = all.with(track.later(frame));
        }
        return all.withFrames(all.first(), Math.max(all.last(), Math.addExact(frame, shot.last())));
    }

    /** The number of keys of the position, which is that of the direction. */
    public int keys() {
        return shot.tracks().getFirst().keys().size();
    }

    /** The number of frames from the first key to the last, both included. */
    public int frames() {
        return shot.last() + 1;
    }
}
