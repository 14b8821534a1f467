package lightning.format.jen;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Map;
import lightning.scene.Dome;
import lightning.scene.NamedCamera;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.light.Light;
import lightning.scene.light.LightGroup;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/**
 * Content of a block as it must be written for a scene record.
 *
 * @param name empty if the type has no name
 * @param values all values by property name, written or default
 */
record BlockContent(BlockType<?> type, String name, Map<String, Value> values, List<BlockContent> children) {

    static <T> BlockContent of(BlockType<T> type, T record) {
        return new BlockContent(type, "", type.values(record), List.of());
    }

    static <T> BlockContent of(Scene scene, SceneElement<T> element) {
        return of(BlockTypes.of(scene, element), element.get(scene)).withName(element.name());
    }

    static BlockContent of(Material m) {
        return of(BlockTypes.MATERIAL, m).withName(m.name());
    }

    static BlockContent of(Light l) {
        return of(BlockTypes.LIGHT, l).withName(l.name());
    }

    static BlockContent of(LightGroup b) {
        return of(BlockTypes.LIGHT_GROUP, b).withName(b.name());
    }

    static BlockContent of(NamedCamera c) {
        return of(BlockTypes.NAMED_CAMERA, c).withName(c.name());
    }

    static BlockContent of(Dome d) {
        return of(BlockTypes.DOME, d).withName(d.name());
    }

    static BlockContent of(SceneNode node) {
        BlockContent element = switch (node) {
            case NodeGroup g -> new BlockContent(BlockTypes.GROUP, "", BlockTypes.GROUP.values(g),
                    g.children().stream().map(BlockContent::of).toList());
            case Shape s -> of(BlockTypes.of(s.solid()), s);
        };
        return element.withName(node.name());
    }

    private BlockContent withName(String newName) {
        return new BlockContent(type, newName, values, children);
    }

    /** Returns the value of one of the type's properties. */
    Value value(Property<?> property) {
        return requireNonNull(values.get(property.name()));
    }

    /** Returns whether {@code property} must be written: it is present and differs from the default. */
    boolean mustWrite(Property<?> property) {
        Value value = value(property);
        return !(value instanceof Value.Absent) && !value.equals(property.initial());
    }

    /** Returns whether all values are defaults, so that no block is needed. */
    boolean isInitial() {
        return type.properties().stream().noneMatch(this::mustWrite);
    }
}
