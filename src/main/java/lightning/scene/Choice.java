package lightning.scene;

import java.util.List;
import java.util.Locale;

/**
 * One of a few words.
 *
 * @param all   the values
 * @param words what a file writes for each, in the same order
 */
public record Choice<V>(List<V> all, List<String> words) implements ValueKind.OfLight<V>, ValueKind.OfMaterial<V> {
    static final Choice<Boolean> YES_OR_NO = new Choice<>(List.of(true, false), List.of("yes", "no"));

    /** The constants of an enum, in lower case. */
    static <E extends Enum<E>> Choice<E> of(Class<E> type) {
        List<E> all = List.of(type.getEnumConstants());
        return new Choice<>(all, all.stream().map(e -> e.name().toLowerCase(Locale.ROOT)).toList());
    }

    /** The value of one of the words. */
    public V value(String word) {
        return all.get(words.indexOf(word));
    }

    @Override
    public void check(String what, V value) {
        // The type has no other values.
    }

    @Override
    public boolean alike(V a, V b) {
        return a.equals(b);
    }

    @Override
    public String text(V value) {
        return words.get(all.indexOf(value));
    }
}
