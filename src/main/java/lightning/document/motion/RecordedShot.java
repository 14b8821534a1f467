package lightning.document.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Shot;
import lightning.scene.shot.Track;
import lightning.scene.value.SceneLimits;

/**
 * Shot of one light that was moved in the preview (paper §3.7), with linear position and direction keyframes at regular intervals.
 *
 * @param interval frames between keyframes, 1…{@value #MAX_INTERVAL}
 * @param shot     frames from 0 to the last keyframe; its tracks are position and direction, with keyframes at the same frames
 */
public record RecordedShot(int interval, Shot shot) {
    public static final int DEFAULT_INTERVAL = 10;
    public static final int MAX_INTERVAL = 10_000;
    public static final int MAX_KEYS = 100_000;

    public RecordedShot {
        SceneLimits.checkRange("every", interval, 1, MAX_INTERVAL);
        SceneLimits.checkRange("the number of keys", shot.tracks().getFirst().keys().size(), 1, MAX_KEYS);
    }

    /** @param samples light at each keyframe, at least one */
    static RecordedShot of(int interval, List<Light> samples) {
        return ofTracks(interval,
                List.of(track(LightAttribute.POSITION, interval, samples), track(LightAttribute.DIRECTION, interval, samples)));
    }

    private static Track track(LightAttribute<Vec3> attribute, int interval, List<Light> samples) {
        List<Keyframe> keys = new ArrayList<>();
        for (Light sample : samples) {
            Vec3 v = attribute.get(sample);
            keys.add(new Keyframe(keys.size() * interval, new KeyframeValue.Numbers(List.of(v.x(), v.y(), v.z())), Interpolation.LINEAR));
        }
        return new Track(new SceneElement.OfLight(samples.getFirst().name()), attribute.name(), keys);
    }

    private static RecordedShot ofTracks(int interval, List<Track> tracks) {
        return new RecordedShot(interval, new Shot(0, tracks.getFirst().keys().getLast().frame(), Shot.DEFAULT.rate(), tracks));
    }

    /**
     * Returns a light's movement in a shot, its first keyframe at frame 0. Empty if the light's position and direction do not have linear
     * keyframes at the same, evenly spaced frames.
     */
    public static Optional<RecordedShot> of(Shot shot, String light) {
        List<Track> tracks = Stream.of(LightAttribute.POSITION, LightAttribute.DIRECTION)
                .flatMap(a -> shot.track(new SceneElement.OfLight(light), a.name()).stream()).toList();
        if (tracks.size() < 2 || tracks.getFirst().keys().size() > MAX_KEYS) {
            return Optional.empty();
        }
        List<Keyframe> keys = tracks.getFirst().keys();
        int first = keys.getFirst().frame();
        int interval = keys.size() == 1 ? DEFAULT_INTERVAL : keys.get(1).frame() - first;
        boolean isEven = interval <= MAX_INTERVAL && tracks.stream().allMatch(t -> hasEvenKeys(t, first, interval, keys.size()));
        return isEven ? Optional.of(ofTracks(interval, tracks.stream().map(t -> t.shift(-first)).toList())) : Optional.empty();
    }

    private static boolean hasEvenKeys(Track track, int first, int interval, int size) {
        for (int i = 0; i < track.keys().size(); i++) {
            Keyframe key = track.keys().get(i);
            if (key.frame() != first + (long) i * interval || key.interpolation() != Interpolation.LINEAR) {
                return false;
            }
        }
        return track.keys().size() == size;
    }

    /**
     * Returns another shot in which the light follows this movement from a frame on. Replaces the light's position and direction keyframes
     * there. Extends the shot if it ends before the last keyframe.
     *
     * @throws IllegalArgumentException if a keyframe would be after {@link Shot#MAX_FRAME}, or if there were too many
     */
    public Shot addTo(Shot other, int frame) {
        Shot all = other;
        for (Track track : shot.tracks()) {
            all = all.with(track.shift(frame));
        }
        return all.withFrames(all.first(), Math.max(all.last(), Math.addExact(frame, shot.last())));
    }

    /** Returns the number of position keyframes, which equals that of the direction. */
    public int keyCount() {
        return shot.tracks().getFirst().keys().size();
    }

    /** Returns the number of frames from the first to the last keyframe, inclusive. */
    public int frameCount() {
        return shot.last() + 1;
    }
}
