package lightning.format.jen;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.math.Vec3;
import lightning.base.text.RefusalException;
import lightning.format.jen.asset.AssetSource;
import lightning.scene.asset.Environment;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TextureUsage;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.node.Solid;
import lightning.scene.value.ShapeGains;
import org.jspecify.annotations.Nullable;

/**
 * All values of one block, written or default, converted to scene types.
 *
 * @param lookup returns the value of a property by name, or null
 * @param files source of the referenced assets
 */
record PropertyValues(Function<String, @Nullable Value> lookup, AssetSource files) {

    /** Returns the record with all given attributes set from the block. */
    <T> T applyAll(T record, List<? extends SceneAttribute<T, ?>> attributes) {
        T result = record;
        for (SceneAttribute<T, ?> attribute : attributes) {
            result = applyAll(result, attribute);
        }
        return result;
    }

    private <T, V> T applyAll(T record, SceneAttribute<T, V> attribute) {
        return attribute.with(record, attributeValue(attribute));
    }

    /** Returns the value of an attribute. */
    <V> V attributeValue(SceneAttribute<?, V> attribute) {
        return switch (attribute.kind()) {
            case NumericKind<V> n -> n.compose().apply(numbers(attribute.name()));
            case ChoiceKind<V> c -> c.parse(word(attribute.name()));
            case ValueKind.LinksKind _ -> unchecked(((Value.LinkSet) lookup.apply(attribute.name())).links());
            case ValueKind.GainsKind _ -> unchecked(lookup.apply(attribute.name()) instanceof Value.Gains(ShapeGains gains) ? gains
                    : ShapeGains.NONE);
            case ValueKind.NameKind _ -> unchecked(lookup.apply(attribute.name()) instanceof Value.Name(String name) ? name : "");
            case ValueKind.GoboKind _ -> unchecked(fileValue(attribute, file -> new Gobo(file, files.texture(file, TextureUsage.COLOR))));
            case ValueKind.LightTextureKind _ ->
                    unchecked(fileValue(attribute, file -> new LightTexture(file, files.texture(file, TextureUsage.EMISSION))));
            case ValueKind.ProfileKind _ -> unchecked(fileValue(attribute, file -> new IesProfile(file, files.profile(file))));
            case ValueKind.EnvironmentKind _ -> unchecked(fileValue(attribute, file -> new Environment(file, files.environment(file))));
            case ValueKind.TextureKind t -> unchecked(texture(attribute.name(), t));
        };
    }

    private <F> Optional<F> fileValue(SceneAttribute<?, ?> attribute, Function<String, F> reader) {
        return lookup.apply(attribute.name()) instanceof Value.Quoted(String file) ? Optional.of(reader.apply(file)) : Optional.empty();
    }

    private Optional<TextureMap> texture(String name, ValueKind.TextureKind kind) {
        var itself = new SceneAttribute<Optional<TextureMap>, Optional<TextureMap>>(name, name, kind, Optional.empty(), "", map -> map,
                (_, map) -> map);
        return fileValue(itself, file -> new TextureMap(file, 1, 1, files.texture(file, kind.usage())))
                .flatMap(map -> applyAll(Optional.of(map), kind.placement(itself)));
    }

    /** Casts a value whose attribute kind guarantees type {@code V}, which the compiler cannot verify. */
    @SuppressWarnings("unchecked")
    private static <V> V unchecked(Object value) {
        return (V) value;
    }

    /**
     * Returns the mesh that the block references.
     *
     * @throws RefusalException if it references none, or the mesh cannot be used
     */
    Solid.TriangleMesh triangles() {
        if (!(lookup.apply(BlockTypes.FILE) instanceof Value.Quoted(String file))) {
            throw new RefusalException("expected a " + BlockTypes.FILE + ", found none");
        }
        String part = lookup.apply(BlockTypes.PART) instanceof Value.Name(String name) ? name : "";
        return new Solid.TriangleMesh(file, part, word(BlockTypes.COLORS).equals("yes"), files.mesh(file, part));
    }

    /** Returns the record of a nested block; empty if the block is absent. */
    <B> Optional<B> nested(BlockType<B> type) {
        return lookup.apply(type.keyword()) instanceof Value.Nested(BlockContent content)
                ? Optional.of(type.builder().build("", new PropertyValues(content.values()::get, files), List.of())) : Optional.empty();
    }

    double number(String property) {
        return numbers(property).get(0);
    }

    int integer(String property, int index) {
        return numbers(property).get(index).intValue();
    }

    Vec3 vector(String property) {
        List<Double> n = numbers(property);
        return new Vec3(n.get(0), n.get(1), n.get(2));
    }

    String word(String property) {
        return ((Value.Word) lookup.apply(property)).text();
    }

    String name(String property) {
        return ((Value.Name) lookup.apply(property)).name();
    }

    private List<Double> numbers(String property) {
        return ((Value.Numbers) lookup.apply(property)).values();
    }
}
