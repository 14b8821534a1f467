package lightning.format.exchange;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.ChoiceKind;
import lightning.scene.KeyframeSupport;
import lightning.scene.NumericKind;
import lightning.scene.SceneAttribute;
import lightning.scene.ValueKind;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/** Keyframes of attributes whose values are known at every frame. Frames on a straight line between two others get none. */
final class FrameTracks {
    /** Largest distance from the line, as a share of the values: stages have floats, of about seven digits. */
    private static final double TOLERANCE = 1e-6;

    private final int first;

    /** @param first number of the first frame */
    FrameTracks(int first) {
        this.first = first;
    }

    /**
     * Returns the tracks of all attributes that change.
     *
     * @param frames values at each frame
     */
    <T> List<Track> of(TrackTarget target, List<? extends SceneAttribute<T, ?>> attributes, List<T> frames) {
        List<Track> tracks = new ArrayList<>();
        for (SceneAttribute<T, ?> attribute : attributes) {
            track(target, attribute, frames).ifPresent(tracks::add);
        }
        return tracks;
    }

    private <T, V> Optional<Track> track(TrackTarget target, SceneAttribute<T, V> attribute, List<T> frames) {
        ValueKind<V> kind = attribute.kind();
        V start = attribute.get(frames.getFirst());
        if (kind.keyframeSupport() == KeyframeSupport.NONE || frames.stream().allMatch(f -> attribute.get(f).equals(start))) {
            return Optional.empty();
        }
        List<KeyframeValue> values = frames.stream().map(f -> value(kind, attribute.get(f))).toList();
        boolean isStepped = kind.keyframeSupport() == KeyframeSupport.STEPPED;
        boolean isDirection = kind instanceof NumericKind<V> n && n.form() == NumericKind.Form.DIRECTION;
        List<Keyframe> keys = new ArrayList<>();
        for (int i = 0; i < values.size();) {
            keys.add(new Keyframe(first + i, values.get(i), isStepped ? Interpolation.STEPPED : Interpolation.LINEAR));
            i = isStepped ? nextDifferent(values, i) : isDirection ? i + 1 : endOfLine(values, i);
        }
        return Optional.of(new Track(target, attribute.name(), keys));
    }

    private static <V> KeyframeValue value(ValueKind<V> kind, V value) {
        return kind instanceof NumericKind<V> n ? new KeyframeValue.Numbers(n.components().apply(value))
                : new KeyframeValue.Word(((ChoiceKind<V>) kind).format(value));
    }

    private static int nextDifferent(List<KeyframeValue> values, int start) {
        int i = start + 1;
        while (i < values.size() && values.get(i).equals(values.get(start))) {
            i++;
        }
        return i;
    }

    /** Returns the last frame such that all between are on a straight line; the number of frames after the last one. */
    private static int endOfLine(List<KeyframeValue> values, int start) {
        int end = start + 1;
        while (end + 1 < values.size() && isLine(values, start, end + 1)) {
            end++;
        }
        return end;
    }

    private static boolean isLine(List<KeyframeValue> values, int start, int end) {
        List<Double> from = numbers(values, start);
        List<Double> to = numbers(values, end);
        for (int i = start + 1; i < end; i++) {
            double t = (double) (i - start) / (end - start);
            for (int c = 0; c < from.size(); c++) {
                double scale = Math.max(Math.abs(from.get(c)), Math.abs(to.get(c)));
                if (!(Math.abs(numbers(values, i).get(c) - from.get(c) * (1 - t) - to.get(c) * t) <= TOLERANCE * scale)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static List<Double> numbers(List<KeyframeValue> values, int index) {
        return ((KeyframeValue.Numbers) values.get(index)).values();
    }
}
