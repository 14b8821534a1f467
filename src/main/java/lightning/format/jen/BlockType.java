package lightning.format.jen;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.scene.SceneNode;

/**
 * One kind of block.
 *
 * @param <T>        the record of the scene that the block describes
 * @param keyword    the word that begins it
 * @param isNamed      whether a name follows
 * @param header     the property whose bare value follows the name, if any
 * @param properties those in the braces, in the order in which they are written
 * @param initials   what each of these is where the file does not say, by its name
 * @param builder    makes the record
 */
record BlockType<T>(String keyword, boolean isNamed, Optional<Property<T>> header, List<Property<T>> properties,
        Map<String, Value> initials, Builder<T> builder) {

    BlockType(String keyword, boolean isNamed, Optional<Property<T>> header, List<Property<T>> properties, Builder<T> builder) {
        this(keyword, isNamed, header, properties,
                properties.stream().collect(Collectors.toUnmodifiableMap(Property::name, Property::initial)), builder);
    }

    /** Makes the record that a block describes from values that were each checked. */
    @FunctionalInterface
    interface Builder<T> {
        /** @throws IllegalArgumentException if the values do not go together; the message says why */
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

    /** The values of {@code record} by property name, that of the header included. */
    Map<String, Value> values(T record) {
        Map<String, Value> values = new LinkedHashMap<>();
        header.ifPresent(p -> values.put(p.name(), p.getter().apply(record)));
        properties.forEach(p -> values.put(p.name(), p.getter().apply(record)));
        return values;
    }
}
