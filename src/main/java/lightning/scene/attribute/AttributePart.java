package lightning.scene.attribute;

import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Component of a scene record that has attributes of its own, such as the fog of a world.
 *
 * @param <T>     type of the record
 * @param <P>     type of the component
 * @param initial component if a file does not set it
 * @param get     returns the component of a record
 * @param with    returns a record with another component
 * @param missing returns a clause that says why most attributes of the component have no effect; empty if they have
 */
public record AttributePart<T, P>(P initial, Function<T, P> get, BiFunction<T, P, T> with, Function<T, Optional<String>> missing) {
    /** Creates a component whose attributes have an effect. */
    public AttributePart(P initial, Function<T, P> get, BiFunction<T, P, T> with) {
        this(initial, get, with, _ -> Optional.empty());
    }

    /** Returns the access of an attribute of the record to a value of the component. */
    public <V> Function<T, V> getter(Function<P, V> value) {
        return get.andThen(value);
    }

    /** Returns the change of the record that changes a value of the component. */
    public <V> BiFunction<T, V, T> setter(BiFunction<P, V, P> change) {
        return (owner, v) -> with.apply(owner, change.apply(get.apply(owner), v));
    }

    /**
     * Returns an attribute of the record.
     *
     * @param name  keyword in a scene file
     * @param title name for the user, lower case
     * @param unit  unit for the documents; empty for none
     */
    public <V> SceneAttribute<T, V> attribute(String name, String title, ValueKind<V> kind, String unit, Function<P, V> value,
            BiFunction<P, V, P> change) {
        return new SceneAttribute<>(name, title, kind, value.apply(initial), unit, getter(value), setter(change)).inactiveIf(missing);
    }
}
