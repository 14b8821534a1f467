package lightning.scene.shot;

import java.util.List;
import lightning.base.text.RefusalException;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;

/** Value of a keyframe, as in a file. */
public sealed interface KeyframeValue {
    /** One or several finite numbers. */
    record Numbers(List<Double> values) implements KeyframeValue {
        public Numbers {
            values = List.copyOf(values);
            for (double number : values) {
                if (!Double.isFinite(number)) {
                    throw new RefusalException("a key must be a number, was " + number);
                }
            }
        }
    }

    /** One word of a fixed set. */
    record Word(String text) implements KeyframeValue {}

    /**
     * Returns the value that equals an attribute's current value.
     *
     * @throws IllegalArgumentException if the scene does not have the element, if it lacks the attribute, or if that cannot be animated
     */
    static <T> KeyframeValue of(Scene scene, SceneElement<T> element, String attribute) {
        T record = element.get(scene);
        return element.attribute(scene, attribute).map(a -> of(record, a, element))
                .orElseThrow(() -> new RefusalException(element.label() + " has no " + attribute + " that can be animated"));
    }

    private static <T, V> KeyframeValue of(T record, SceneAttribute<T, V> attribute, SceneElement<T> element) {
        return switch (attribute.kind()) {
            case NumericKind<V> q -> new Numbers(q.components().apply(attribute.get(record)));
            case ChoiceKind<V> c -> new Word(c.format(attribute.get(record)));
            case ValueKind.AssetKind<?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.TextureKind _ ->
                    throw new RefusalException(
                            element.label() + ": " + attribute.name() + " cannot be animated: only numbers and words can");
        };
    }
}
