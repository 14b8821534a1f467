package lightning.format.jen;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.math.Vec3;
import lightning.scene.Attribute;
import lightning.scene.Choice;
import lightning.scene.Gobo;
import lightning.scene.Panorama;
import lightning.scene.Profile;
import lightning.scene.Quantity;
import lightning.scene.SampleMeaning;
import lightning.scene.Solid;
import lightning.scene.TextureMap;
import lightning.scene.ValueKind;

/**
 * All values of one block, written or by default, in the types of the scene.
 *
 * @param all   the value of a property by its name; null where there is none
 * @param files finds what the files hold that the block names
 */
record Values(Function<String, Value> all, SceneFiles files) {

    /** The record with all of these attributes as the block has them. */
    <T> T on(T record, List<? extends Attribute<T, ?>> attributes) {
        T on = record;
        for (Attribute<T, ?> attribute : attributes) {
            on = on(on, attribute);
        }
        return on;
    }

    private <T, V> T on(T record, Attribute<T, V> attribute) {
        return attribute.with(record, of(attribute));
    }

    /** The value of an attribute. */
    <V> V of(Attribute<?, V> attribute) {
        return switch (attribute.kind()) {
            case Quantity<V> n -> n.join().apply(numbers(attribute.name()));
            case Choice<V> c -> c.value(word(attribute.name()));
            case ValueKind.Linking _ -> unchecked(((Value.Linked) all.apply(attribute.name())).links());
            case ValueKind.Naming _ -> unchecked(all.apply(attribute.name()) instanceof Value.Name(String name) ? name : "");
            case ValueKind.Projecting _ -> unchecked(filed(attribute, file -> new Gobo(file, files.texture(file, SampleMeaning.COLOR))));
            case ValueKind.Shining _ -> unchecked(filed(attribute, file -> new Profile(file, files.profile(file))));
            case ValueKind.Surrounding _ -> unchecked(filed(attribute, file -> new Panorama(file, files.sky(file))));
            case ValueKind.Texturing t -> unchecked(filed(attribute, file -> picture(file, t)));
        };
    }

    private <F> Optional<F> filed(Attribute<?, ?> attribute, Function<String, F> read) {
        return all.apply(attribute.name()) instanceof Value.Quoted(String file) ? Optional.of(read.apply(file)) : Optional.empty();
    }

    private TextureMap picture(String file, ValueKind.Texturing as) {
        return new TextureMap(file, number(as.repeat(), 0), number(as.repeat(), 1), files.texture(file, as.samples()));
    }

    /** A value of which the kind of the attribute has told that it is a {@code V}: the compiler cannot follow that. */
    @SuppressWarnings("unchecked")
    private static <V> V unchecked(Object value) {
        return (V) value;
    }

    /**
     * The triangles of the file that the block names.
     *
     * @throws IllegalArgumentException if it names none, or none that can be used
     */
    Solid.Triangles triangles() {
        if (!(all.apply(Blocks.FILE) instanceof Value.Quoted(String file))) {
            throw new IllegalArgumentException("expected a " + Blocks.FILE + ", found none");
        }
        String part = all.apply(Blocks.PART) instanceof Value.Name(String name) ? name : "";
        return new Solid.Triangles(file, part, word(Blocks.COLORS).equals("yes"), files.mesh(file, part));
    }

    double number(String property) {
        return numbers(property).get(0);
    }

    int whole(String property, int index) {
        return numbers(property).get(index).intValue();
    }

    double number(String property, int index) {
        return numbers(property).get(index);
    }

    Vec3 vector(String property) {
        List<Double> n = numbers(property);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    String word(String property) {
        return ((Value.Word) all.apply(property)).text();
    }

    String name(String property) {
        return ((Value.Name) all.apply(property)).name();
    }

    private List<Double> numbers(String property) {
        return ((Value.Numbers) all.apply(property)).all();
    }
}
