package lightning.scene.shot;

import java.util.List;

/** What a key says: the value as a file writes it. */
public sealed interface Setting {
    /** One number or several, all finite. */
    record Numbers(List<Double> all) implements Setting {
        public Numbers {
            all = List.copyOf(all);
            for (double number : all) {
                if (!Double.isFinite(number)) {
                    throw new IllegalArgumentException("a key must be a number, was " + number);
                }
            }
        }
    }

    /** One of a few words. */
    record Word(String text) implements Setting {}
}
