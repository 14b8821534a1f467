package lightning.format.exchange.usd;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.format.exchange.assembly.KeyframeReduction;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Track;
import lightning.scene.shot.TrackTarget;

/**
 * Keyframes of attributes whose values are known at every frame. Frames on a straight line between two others get none.
 *
 * @param first number of the first frame
 */
record FrameTracks(int first) {
    private static final KeyframeReduction REDUCTION = new KeyframeReduction(0);

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
        boolean isStepped = kind.keyframeSupport() == KeyframeSupport.STEPPED;
        boolean isDirection = kind instanceof NumericKind<V> n && n.form() == NumericKind.Form.DIRECTION;
        List<Keyframe> keys = new ArrayList<>();
        for (int i = 0; i < frames.size(); i++) {
            keys.add(new Keyframe(first + i, value(kind, attribute.get(frames.get(i))),
                    isStepped ? Interpolation.STEPPED : Interpolation.LINEAR));
        }
        return Optional.of(new Track(target, attribute.name(), REDUCTION.reduce(keys, !isDirection)));
    }

    private static <V> KeyframeValue value(ValueKind<V> kind, V value) {
        return kind instanceof NumericKind<V> n ? new KeyframeValue.Numbers(n.components().apply(value))
                : new KeyframeValue.Word(((ChoiceKind<V>) kind).format(value));
    }
}
