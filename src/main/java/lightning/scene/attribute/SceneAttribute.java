package lightning.scene.attribute;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import lightning.base.file.ContentDigest;
import org.jspecify.annotations.Nullable;

/**
 * Descriptor of one attribute of a scene record: name, kind, initial value, unit and access. The file format, the command line's edits, the
 * editor's widgets, undo descriptions and the tables of the documents use it.
 *
 * @param <T> type of the record
 * @param <V> type of the values
 */
public class SceneAttribute<T, V> {
    private final String name;
    private final String id;
    private final String title;
    private final ValueKind<V> kind;
    private final V initial;
    private final String unit;
    private final Function<T, V> getter;
    private final BiFunction<T, V, T> setter;
    private final Function<T, Optional<String>> inactiveReason;

    /**
     * @param name    keyword in a scene file
     * @param title   name for the user, lower case
     * @param initial value if a file does not set it
     * @param unit    unit for the documents; empty for none
     */
    public SceneAttribute(String name, String title, ValueKind<V> kind, V initial, String unit, Function<T, V> getter,
            BiFunction<T, V, T> setter) {
        this(name, title, title, kind, initial, unit, getter, setter);
    }

    /** @param id  stable name that does not follow changes of the title */
    public SceneAttribute(String name, String id, String title, ValueKind<V> kind, V initial, String unit, Function<T, V> getter,
            BiFunction<T, V, T> setter) {
        this(name, id, title, kind, initial, unit, getter, setter, _ -> Optional.empty());
    }

    private SceneAttribute(String name, String id, String title, ValueKind<V> kind, V initial, String unit, Function<T, V> getter,
            BiFunction<T, V, T> setter, Function<T, Optional<String>> inactiveReason) {
        this.name = name;
        this.id = id;
        this.title = title;
        this.kind = kind;
        this.initial = initial;
        this.unit = unit;
        this.getter = getter;
        this.setter = setter;
        this.inactiveReason = inactiveReason;
    }

    /** @param reason returns a clause that says why the attribute has no effect in a record; empty if it has */
    public SceneAttribute<T, V> inactiveIf(Function<T, Optional<String>> reason) {
        return new SceneAttribute<>(name, id, title, kind, initial, unit, getter, setter, reason);
    }

    /** Returns a clause that says why it has no effect in a record; empty if it has. */
    public Optional<String> inactiveReason(T record) {
        return inactiveReason.apply(record);
    }

    public final String name() {
        return name;
    }

    /** Returns the stable name that ids of controls, range errors and benchmark results use. */
    public final String id() {
        return id;
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

    public final V get(@Nullable T record) {
        return getter.apply(record);
    }

    /**
     * Returns the record with another value.
     *
     * @throws IllegalArgumentException if the record may not have the value; the message says why
     */
    public final T with(T record, V value) {
        return setter.apply(record, value);
    }

    /** Returns the record with the initial value. */
    public final T reset(T record) {
        return with(record, initial);
    }

    /** Returns {@code to} with the value of {@code from}. */
    public final T copy(@Nullable T from, T to) {
        return with(to, get(from));
    }

    /** Returns the name of the file that the value refers to, as in the scene file; empty if there is none. */
    public final Optional<String> file(T record) {
        return kind.file(get(record));
    }

    /** Returns the content of that file. */
    public final Optional<? extends ContentDigest.Content> content(T record) {
        return kind.content(get(record));
    }

    /**
     * Returns the record with another name of the file that the value refers to.
     *
     * @param newName returns the new name for the old one
     */
    public final T renameFile(T record, UnaryOperator<String> newName) {
        return file(record).isEmpty() ? record : with(record, kind.renameFile(get(record), newName));
    }

    /** Returns whether the values of both records have the same effect. */
    public boolean isEquivalent(T a, T b) {
        return kind.isEquivalent(get(a), get(b));
    }

    /** Formats the value for the user, with few digits. */
    public final String format(T record) {
        return kind.format(get(record));
    }

    /** @throws IllegalArgumentException if no record may have the value; the message says why */
    public final void check(V value) {
        kind.check(id, value);
    }

    @Override
    public final String toString() {
        return title;
    }
}
