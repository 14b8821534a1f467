package lightning.scene.shot;

import java.util.List;
import lightning.base.text.RefusalException;

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
}
