package lightning.scene;

import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * One attribute of a record of the scene: everything that is known of it but what it means. The format's blocks, the edits
 * of the command line, the editor's widgets, the words of undo and the tables of the documents follow from it.
 *
 * @param <T> the record that has it
 * @param <V> the type of its values
 */
public sealed class SceneAttribute<T, V> permits LightAttribute, MaterialAttribute {
    private final String name;
    private final String title;
    private final ValueKind<V> kind;
    private final V initial;
    private final String unit;
    private final Function<T, V> getter;
    private final BiFunction<T, V, T> setter;

    /**
     * @param name    as a scene file writes it
     * @param title   as people are told it, lower case
     * @param initial the value where a file does not say
     * @param unit    for the documents; empty where there is none
     */
    SceneAttribute(String name, String title, ValueKind<V> kind, V initial, String unit, Function<T, V> getter,
            BiFunction<T, V, T> setter) {
        this.name = name;
        this.title = title;
        this.kind = kind;
        this.initial = initial;
        this.unit = unit;
        this.getter = getter;
        this.setter = setter;
    }

    public final String name() {
        return name;
    }

    public final String title() {
        return title;
    }

    public ValueKind<V> kind() {
        return kind;
    }

    public final V initial() {
        return initial;
    }

    public final String unit() {
        return unit;
    }

    public final V get(T record) {
        return getter.apply(record);
    }

    /**
     * The record with another value.
     *
     * @throws IllegalArgumentException if the record may not have it; the message says why
     */
    public final T with(T record, V value) {
        return setter.apply(record, value);
    }

    /** {@code to} with the value that {@code from} has. */
    public final T copy(T from, T to) {
        return with(to, get(from));
    }

    /** Whether the values of two records do the same wherever they act. */
    public boolean isEquivalent(T a, T b) {
        return kind.isEquivalent(get(a), get(b));
    }

    /** The value for people, in a few digits. */
    public final String format(T record) {
        return kind.format(get(record));
    }

    /** @throws IllegalArgumentException if no record may have the value; the message says why */
    final void check(V value) {
        kind.check(title, value);
    }

    @Override
    public final String toString() {
        return title;
    }
}
