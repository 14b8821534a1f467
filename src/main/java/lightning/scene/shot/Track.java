package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.ChoiceKind;
import lightning.scene.KeyframeSupport;
import lightning.scene.NumericKind;
import lightning.scene.Scene;
import lightning.scene.SceneAttribute;
import lightning.scene.ValueKind;

/**
 * The keys of one attribute of something.
 *
 * @param attribute its name as a file writes it
 * @param keys      one at least, in the order of their frames, one for a frame
 */
public record Track(TrackTarget target, String attribute, List<Keyframe> keys) {
    public Track {
        keys = List.copyOf(keys);
        if (keys.isEmpty()) {
            throw new IllegalArgumentException(target + ": " + attribute + " must have a keyframe");
        }
        for (int i = 1; i < keys.size(); i++) {
            if (keys.get(i).frame() <= keys.get(i - 1).frame()) {
                throw new IllegalArgumentException(target + ": " + attribute + ": keyframes must be in frame order, found "
                        + keys.get(i).frame() + " after " + keys.get(i - 1).frame());
            }
        }
    }

    /** These keys of something else. */
    public Track withTarget(TrackTarget newTarget) {
        return new Track(newTarget, attribute, keys);
    }

    /** These keys some frames later, or earlier where the number is negative. */
    public Track shift(int frames) {
        return new Track(target, attribute,
                keys.stream().map(k -> new Keyframe(Math.addExact(k.frame(), frames), k.value(), k.interpolation())).toList());
    }

    /** The key at a frame. */
    public Optional<Keyframe> key(int frame) {
        return keys.stream().filter(k -> k.frame() == frame).findFirst();
    }

    /** These keys and another, in place of the one at its frame. */
    public Track with(Keyframe key) {
        List<Keyframe> newKeys = new ArrayList<>(keys);
        int index = 0;
        while (index < newKeys.size() && newKeys.get(index).frame() < key.frame()) {
            index++;
        }
        if (index < newKeys.size() && newKeys.get(index).frame() == key.frame()) {
            newKeys.set(index, key);
        } else {
            newKeys.add(index, key);
        }
        return new Track(target, attribute, newKeys);
    }

    /** With another value at a frame: the key there goes on as it did, a new one as the key before it, or as the first. */
    public Track with(int frame, KeyframeValue setting) {
        Keyframe previous = keys.getFirst();
        for (Keyframe key : keys) {
            previous = key.frame() <= frame ? key : previous;
        }
        return with(new Keyframe(frame, setting, previous.interpolation()));
    }

    /**
     * Refuses keys that the scene cannot have.
     *
     * @throws IllegalArgumentException if what has them is not there, or lacks the attribute, or if the attribute has no keys at all or
     *                                  may not have one's value
     */
    public void check(Scene scene) {
        check(target.attribute(scene, attribute).<SceneAttribute<?, ?>>map(a -> a)
                .orElseThrow(() -> new IllegalArgumentException(target + " has no " + attribute + " that can be animated")));
    }

    /**
     * Refuses keys that the attribute cannot have.
     *
     * @throws IllegalArgumentException if it has none at all, if a value is none of its own, or if words or whole numbers are to
     *                                  go from key to key
     */
    private void check(SceneAttribute<?, ?> definition) {
        if (definition.kind().keyframeSupport() == KeyframeSupport.NONE) {
            throw new IllegalArgumentException(target + ": " + attribute + " cannot be animated: only numbers and words can");
        }
        for (Keyframe key : keys) {
            if (definition.kind().keyframeSupport() == KeyframeSupport.STEPPED && key.interpolation() != Interpolation.STEPPED) {
                throw new IllegalArgumentException(target + ": " + attribute + " holds until its next keyframe, so it must be stepped");
            }
            check(definition.kind(), key.value());
        }
    }

    private <V> void check(ValueKind<V> kind, KeyframeValue setting) {
        boolean isValid = switch (kind) {
            case NumericKind<V> n -> setting instanceof KeyframeValue.Numbers(List<Double> all) && all.size() == n.labels().size();
            case ChoiceKind<V> c -> setting instanceof KeyframeValue.Word(String text) && c.words().contains(text);
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.NameKind _,ValueKind.TextureKind _ -> false;
        };
        if (!isValid) {
            throw new IllegalArgumentException(target + ": " + attribute + " cannot be " + setting);
        }
        if (kind instanceof NumericKind<V> n && setting instanceof KeyframeValue.Numbers(List<Double> all)) {
            all.forEach(number -> n.check(attribute, number.doubleValue()));
        }
        kind.check(attribute, value(kind, setting));
    }

    /**
     * The value at a frame: at a key the key's in every bit, before the first key and behind the last one theirs.
     *
     * @param frame may lie between two frames
     * @param kind  the attribute's
     */
    <V> V evaluate(double frame, ValueKind<V> kind) {
        int index = 0;
        int end = keys.size();
        while (end - index > 1) {
            int middle = (index + end) >>> 1;
            if (keys.get(middle).frame() <= frame) {
                index = middle;
            } else {
                end = middle;
            }
        }
        Keyframe from = keys.get(index);
        if (frame <= from.frame() || index == keys.size() - 1 || from.interpolation() == Interpolation.STEPPED) {
            return value(kind, from.value());
        }
        NumericKind<V> quantity = (NumericKind<V>) kind;
        List<Double> numbers = from.interpolation() == Interpolation.SMOOTH ? interpolateCubic(index, frame)
                : KeyframeInterpolator.linear(quantity.form(), keyNumbers(index), keyNumbers(index + 1), fraction(index, frame));
        return quantity.compose().apply(numbers);
    }

    private double fraction(int index, double frame) {
        int start = keys.get(index).frame();
        return (frame - start) / (keys.get(index + 1).frame() - start);
    }

    private List<Double> interpolateCubic(int index, double frame) {
        List<Double> result = new ArrayList<>();
        for (int i = 0; i < keyNumbers(index).size(); i++) {
            double slope = slope(index, i);
            double next = slope(index + 1, i);
            result.add(KeyframeInterpolator.cubic(keyNumbers(index).get(i), keyNumbers(index + 1).get(i), slope, next,
                    keys.get(index + 1).frame() - keys.get(index).frame(), fraction(index, frame)));
        }
        return result;
    }

    /** The slope at a key, of one number: 0 at both ends. */
    private double slope(int key, int number) {
        if (key == 0 || key == keys.size() - 1) {
            return 0;
        }
        return KeyframeInterpolator.slope(keyNumbers(key - 1).get(number), keyNumbers(key).get(number), keyNumbers(key + 1).get(number),
                keys.get(key).frame() - keys.get(key - 1).frame(), keys.get(key + 1).frame() - keys.get(key).frame());
    }

    private List<Double> keyNumbers(int key) {
        return ((KeyframeValue.Numbers) keys.get(key).value()).values();
    }

    private static <V> V value(ValueKind<V> kind, KeyframeValue setting) {
        return switch (setting) {
            case KeyframeValue.Numbers(List<Double> all) -> ((NumericKind<V>) kind).compose().apply(all);
            case KeyframeValue.Word(String text) -> ((ChoiceKind<V>) kind).parse(text);
        };
    }
}
