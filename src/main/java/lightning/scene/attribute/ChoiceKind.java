package lightning.scene.attribute;

import java.util.List;
import java.util.Locale;

/**
 * Value kind with a fixed set of words.
 *
 * @param values the values
 * @param words  the word of each in a file, in the same order
 * @param labels the word of each in the editor, in the same order
 */
public record ChoiceKind<V>(List<V> values, List<String> words, List<String> labels)
        implements ValueKind.LightKind<V>, ValueKind.MaterialKind<V> {
    public static final ChoiceKind<Boolean> YES_OR_NO = new ChoiceKind<>(List.of(true, false), List.of("yes", "no"));
    public static final ChoiceKind<Boolean> ON_OR_OFF = new ChoiceKind<>(List.of(true, false), List.of("on", "off"));

    /** Creates a kind whose labels are its words. */
    ChoiceKind(List<V> values, List<String> words) {
        this(values, words, words);
    }

    public ChoiceKind<V> withLabels(List<String> newLabels) {
        return new ChoiceKind<>(values, words, newLabels);
    }

    /** Returns a kind for an enum's constants, in lower case. */
    public static <E extends Enum<E>> ChoiceKind<E> of(Class<E> type) {
        List<E> constants = List.of(type.getEnumConstants());
        return new ChoiceKind<>(constants, constants.stream().map(e -> e.name().toLowerCase(Locale.ROOT)).toList());
    }

    /** Returns the value of a word. */
    public V parse(String word) {
        return values.get(words.indexOf(word));
    }

    /** Returns the label of a value in the editor. */
    public String label(V value) {
        return labels.get(values.indexOf(value));
    }

    @Override
    public void check(String name, V value) {
        // A Boolean has no other values.
    }

    @Override
    public String format(V value) {
        return words.get(values.indexOf(value));
    }
}
