package lightning.format.jen;

import java.util.List;
import java.util.Map;
import lightning.scene.Bank;
import lightning.scene.Group;
import lightning.scene.Light;
import lightning.scene.Material;
import lightning.scene.Node;
import lightning.scene.Shape;

/**
 * A record of the scene as the file would say it.
 *
 * @param name   empty where the type has none
 * @param values all values by property name, written or not
 */
record Element(BlockType<?> type, String name, Map<String, Value> values, List<Element> children) {

    static <T> Element of(BlockType<T> type, T record) {
        return new Element(type, "", type.values(record), List.of());
    }

    static Element of(Material m) {
        return of(Blocks.MATERIAL, m).named(m.name());
    }

    static Element of(Light l) {
        return of(Blocks.LIGHT, l).named(l.name());
    }

    static Element of(Bank b) {
        return of(Blocks.BANK, b).named(b.name());
    }

    static Element of(Node node) {
        Element element = switch (node) {
            case Group g -> new Element(Blocks.GROUP, "", Blocks.GROUP.values(g),
                    g.children().stream().map(Element::of).toList());
            case Shape s -> of(Blocks.of(s.solid()), s);
        };
        return element.named(node.name());
    }

    private Element named(String newName) {
        return new Element(type, newName, values, children);
    }

    /** Whether the file must say {@code property}: it is there and not what it is by default. */
    boolean mustSay(Property<?> property) {
        Value value = values.get(property.name());
        return !(value instanceof Value.Absent) && !value.equals(property.initial());
    }

    /** Whether everything is as it is by default, so that no block is needed. */
    boolean isInitial() {
        return type.properties().stream().noneMatch(this::mustSay);
    }
}
