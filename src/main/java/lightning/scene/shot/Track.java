package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;

/**
 * Keyframes of one attribute of a target.
 *
 * @param attribute keyword in a file
 * @param keys      at least one keyframe, in order, at most one per frame
 */
public record Track(SceneElement<?> target, String attribute, List<Keyframe> keys) {
    public Track {
        keys = List.copyOf(keys);
        if (keys.isEmpty()) {
            throw new RefusalException(target.label() + ": " + attribute + " must have a keyframe");
        }
        for (int i = 1; i < keys.size(); i++) {
            if (keys.get(i).frame() <= keys.get(i - 1).frame()) {
                throw new RefusalException(target.label() + ": " + attribute + ": keyframes must be in frame order, found "
                        + keys.get(i).frame() + " after " + keys.get(i - 1).frame());
            }
        }
    }

    /** Returns whether the attributes of an element can have keyframes. */
    public static boolean canAnimate(SceneElement<?> element) {
        return switch (element) {
            case SceneElement.OfCamera _,SceneElement.OfWorld _,SceneElement.OfLight _,SceneElement.OfLightGroup _,SceneElement.OfDome _,SceneElement.OfNode _ ->
                    true;
            case SceneElement.OfPicture _,SceneElement.OfIndirect _,SceneElement.OfMaterial _ -> false;
        };
    }

    /** Returns these keyframes for another target. */
    public Track withTarget(SceneElement<?> newTarget) {
        return new Track(newTarget, attribute, keys);
    }

    /** Returns these keyframes moved by some frames, earlier if negative. */
    public Track shift(int frames) {
        return new Track(target, attribute,
                keys.stream().map(k -> new Keyframe(Math.addExact(k.frame(), frames), k.value(), k.interpolation())).toList());
    }

    /** Returns the keyframe at a frame. */
    public Optional<Keyframe> key(int frame) {
        return keys.stream().filter(k -> k.frame() == frame).findFirst();
    }

    /** Returns this track with a keyframe added, replacing the one at its frame. */
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

    /**
     * Returns this track with another value at a frame. An existing keyframe keeps its interpolation; a new one takes that of the keyframe
     * before it, or of the first.
     */
    public Track with(int frame, KeyframeValue setting) {
        Keyframe previous = keys.getFirst();
        for (Keyframe key : keys) {
            previous = key.frame() <= frame ? key : previous;
        }
        return with(new Keyframe(frame, setting, previous.interpolation()));
    }

    /**
     * Checks that the scene can have these keyframes.
     *
     * @throws IllegalArgumentException if the target is missing or lacks the attribute, or if the attribute cannot be animated or may not
     *     have a keyframe's value
     */
    public void check(Scene scene) {
        if (!target.existsIn(scene)) {
            throw new RefusalException("there is no " + target.label());
        }
        check(target.attribute(scene, attribute).filter(_ -> canAnimate(target))
                .orElseThrow(() -> new RefusalException(target.label() + " has no " + attribute + " that can be animated")));
    }

    /**
     * Checks that the attribute can have these keyframes.
     *
     * @throws IllegalArgumentException if it cannot be animated, if a value is invalid, or if words or whole numbers are interpolated
     */
    private void check(SceneAttribute<?, ?> definition) {
        if (definition.kind().keyframeSupport() == KeyframeSupport.NONE) {
            throw new RefusalException(target.label() + ": " + attribute + " cannot be animated: only numbers and words can");
        }
        for (Keyframe key : keys) {
            if (definition.kind().keyframeSupport() == KeyframeSupport.STEPPED && key.interpolation() != Interpolation.STEPPED) {
                throw new RefusalException(
                        target.label() + ": " + attribute + " holds until its next keyframe, so it must be stepped");
            }
            check(definition.kind(), key.value());
        }
    }

    private <V> void check(ValueKind<V> kind, KeyframeValue setting) {
        boolean isValid = switch (kind) {
            case NumericKind<V> n -> setting instanceof KeyframeValue.Numbers(List<Double> all) && all.size() == n.labels().size();
            case ChoiceKind<V> c -> setting instanceof KeyframeValue.Word(String text) && c.words().contains(text);
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.TextureKind _ -> false;
        };
        if (!isValid) {
            throw new RefusalException(target.label() + ": " + attribute + " cannot be " + setting);
        }
        if (kind instanceof NumericKind<V> n && setting instanceof KeyframeValue.Numbers(List<Double> all)) {
            all.forEach(number -> n.check(attribute, number.doubleValue()));
        }
        kind.check(attribute, value(kind, setting));
    }

    /**
     * Returns the value at a frame: exactly a keyframe's value at its frame; before the first and after the last keyframe, their values.
     *
     * @param frame any frame, also fractional
     * @param kind  the attribute's kind
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

    /** Returns the slope of one number at a keyframe: 0 at both ends. */
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
