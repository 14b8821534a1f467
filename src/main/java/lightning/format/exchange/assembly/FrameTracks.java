package lightning.format.exchange.assembly;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.SceneElement;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.Interpolation;
import lightning.scene.shot.Keyframe;
import lightning.scene.shot.KeyframeValue;
import lightning.scene.shot.Track;

/**
 * Keyframes of attributes whose values are known at every frame. Frames on a straight line between two others get none.
 *
 * @param first number of the first frame
 */
public record FrameTracks(int first) {
    /** Number of keys that are reduced at a time: the time for a straight line grows with its square. */
    private static final int BLOCK = 256;
    private static final KeyframeReduction REDUCTION = new KeyframeReduction(0);
    /** Values below it have its tolerance: that of numbers of about nine digits. */
    private static final double ROUNDING_UNIT = 1e-3;

    /**
     * Returns the tracks of all attributes that change.
     *
     * @param frames values at each frame
     */
    public <T> List<Track> of(SceneElement<?> target, List<? extends SceneAttribute<T, ?>> attributes, List<T> frames) {
        return of(target, attributes, frames.getFirst(), frames);
    }

    /**
     * Returns the tracks of all attributes that change, or that have another value than without animation.
     *
     * @param rest values without animation
     * @param frames values at each frame
     */
    public <T> List<Track> of(SceneElement<?> target, List<? extends SceneAttribute<T, ?>> attributes, T rest, List<T> frames) {
        List<Track> tracks = new ArrayList<>();
        for (SceneAttribute<T, ?> attribute : attributes) {
            track(target, attribute, rest, frames).ifPresent(tracks::add);
        }
        return tracks;
    }

    /**
     * Returns the tracks of placement and visibility of a shape or group.
     *
     * @param states the node at each frame
     */
    public List<Track> of(SceneNode node, List<SceneNode> states) {
        return of(node, states.getFirst(), states);
    }

    /**
     * Returns the tracks of placement and visibility of a shape or group.
     *
     * @param rest the node without animation
     * @param states the node at each frame
     */
    @SuppressWarnings("unchecked")
    public List<Track> of(SceneNode node, SceneNode rest, List<SceneNode> states) {
        return of(new SceneElement.OfNode(node.name()), (List<SceneAttribute<SceneNode, ?>>) (List<?>) node.attributes().stream()
                .filter(a -> List.of("at", "rotate", "scale", "visible").contains(a.name())).toList(), rest, states);
    }

    private <T, V> Optional<Track> track(SceneElement<?> target, SceneAttribute<T, V> attribute, T rest, List<T> frames) {
        ValueKind<V> kind = attribute.kind();
        V start = attribute.get(frames.getFirst());
        if (kind.keyframeSupport() == KeyframeSupport.NONE
                || frames.stream().allMatch(f -> attribute.get(f).equals(start)) && isNear(kind, attribute.get(rest), start)) {
            return Optional.empty();
        }
        boolean isStepped = kind.keyframeSupport() == KeyframeSupport.STEPPED;
        boolean isDirection = kind instanceof NumericKind<V> n && n.form() == NumericKind.Form.DIRECTION;
        List<Keyframe> keys = new ArrayList<>();
        for (int i = 0; i < frames.size(); i++) {
            keys.add(new Keyframe(first + i, value(kind, attribute.get(frames.get(i))),
                    isStepped ? Interpolation.STEPPED : Interpolation.LINEAR));
        }
        return Optional.of(new Track(target, attribute.name(), reduced(keys, !isDirection)));
    }

    private List<Keyframe> reduced(List<Keyframe> keys, boolean isLinear) {
        if (keys.size() <= BLOCK) {
            return REDUCTION.reduce(keys, isLinear);
        }
        List<Keyframe> kept = new ArrayList<>();
        // Each block starts with the last key of the block before.
        for (int start = 0; start < keys.size() - 1; start += BLOCK) {
            List<Keyframe> part = REDUCTION.reduce(keys.subList(start, Math.min(start + BLOCK + 1, keys.size())), isLinear);
            boolean isRepeated = !kept.isEmpty() && kept.getLast().frame() == part.getFirst().frame();
            kept.addAll(isRepeated ? part.subList(1, part.size()) : part);
        }
        return REDUCTION.reduce(kept, isLinear);
    }

    /** Returns whether two values are the same but for rounding. */
    private static <V> boolean isNear(ValueKind<V> kind, V a, V b) {
        if (a.equals(b) || !(value(kind, a) instanceof KeyframeValue.Numbers(List<Double> one))
                || !(value(kind, b) instanceof KeyframeValue.Numbers(List<Double> other))) {
            return a.equals(b);
        }
        for (int i = 0; i < one.size(); i++) {
            double scale = Math.max(ROUNDING_UNIT, Math.max(Math.abs(one.get(i)), Math.abs(other.get(i))));
            if (!(Math.abs(one.get(i) - other.get(i)) <= KeyframeReduction.TOLERANCE * scale)) {
                return false;
            }
        }
        return true;
    }

    private static <V> KeyframeValue value(ValueKind<V> kind, V value) {
        return kind instanceof NumericKind<V> n ? new KeyframeValue.Numbers(n.components().apply(value))
                : new KeyframeValue.Word(((ChoiceKind<V>) kind).format(value));
    }
}
