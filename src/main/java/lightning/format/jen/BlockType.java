package lightning.format.jen;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.scene.node.SceneNode;

/**
 * Type of a block.
 *
 * @param <T> scene record that the block describes
 * @param keyword first word of the block
 * @param isNamed true if a name follows the keyword
 * @param header property with a bare value after the name, if any
 * @param properties properties in the braces, in writing order
 * @param initials default of each property by name
 * @param builder creates the record
 */
record BlockType<T>(String keyword, boolean isNamed, Optional<Property<T>> header, List<Property<T>> properties,
        Map<String, Value> initials, Builder<T> builder) {

    BlockType(String keyword, boolean isNamed, Optional<Property<T>> header, List<Property<T>> properties, Builder<T> builder) {
        this(keyword, isNamed, header, properties,
                properties.stream().collect(Collectors.toUnmodifiableMap(Property::name, Property::initial)), builder);
    }

    /** Creates the scene record from individually validated values. */
    @FunctionalInterface
    interface Builder<T> {
        /**
         * Builds the record.
         *
         * @throws IllegalArgumentException if the values are inconsistent; the message contains the cause
         */
        T build(String name, PropertyValues values, List<SceneNode> children);
    }

    Optional<Property<T>> property(String name) {
        for (Property<T> p : properties) {
            if (p.name().equals(name)) {
                return Optional.of(p);
            }
        }
        return Optional.empty();
    }

    List<String> propertyNames() {
        return properties.stream().map(Property::name).toList();
    }

    /** Returns the values of {@code record} by property name, including the header. */
    Map<String, Value> values(T record) {
        Map<String, Value> values = new LinkedHashMap<>();
        header.ifPresent(p -> values.put(p.name(), p.getter().apply(record)));
        properties.forEach(p -> values.put(p.name(), p.getter().apply(record)));
        return values;
    }
}
