package lightning.scene.shot;

import java.util.List;

/** What a key says: the value as a file writes it. */
public sealed interface KeyframeValue {
    /** One number or several, all finite. */
    record Numbers(List<Double> values) implements KeyframeValue {
        public Numbers {
            values = List.copyOf(values);
            for (double number : values) {
                if (!Double.isFinite(number)) {
                    throw new IllegalArgumentException("a key must be a number, was " + number);
                }
            }
        }
    }

    /** One of a few words. */
    record Word(String text) implements KeyframeValue {}
}
