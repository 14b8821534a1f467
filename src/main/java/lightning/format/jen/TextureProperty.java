package lightning.format.jen;

import java.util.List;
import java.util.stream.Stream;
import lightning.scene.asset.TextureUsage;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.attribute.ValueKind;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.MaterialAttribute;

/**
 * Property that references an image file.
 *
 * @param dependents properties that need it: repetitions, offset and rotation of the image, and its continuation beyond its edges
 * @param samples meaning of the samples
 */
record TextureProperty(String name, List<String> dependents, TextureUsage samples) {
    private static final List<TextureProperty> OF_MATERIAL = MaterialAttribute.ALL.stream().flatMap(TextureProperty::of).toList();
    private static final List<TextureProperty> OF_LIGHT = LightAttribute.ALL.stream().flatMap(TextureProperty::of).toList();

    /** Returns the image properties of a block. */
    static List<TextureProperty> of(BlockType<?> type) {
        return type == BlockTypes.MATERIAL ? OF_MATERIAL : type == BlockTypes.LIGHT ? OF_LIGHT : List.of();
    }

    private static Stream<TextureProperty> of(SceneAttribute<?, ?> attribute) {
        return switch (attribute.kind()) {
            case ValueKind.TextureKind t ->
                    Stream.of(new TextureProperty(attribute.name(), t.placement(attribute).stream().map(SceneAttribute::name).toList(),
                            t.usage()));
            case ValueKind.GoboKind _ -> Stream.of(new TextureProperty(attribute.name(), List.of(), TextureUsage.COLOR));
            case ValueKind.LightTextureKind _ ->
                    Stream.of(new TextureProperty(attribute.name(), List.of(), TextureUsage.EMISSION));
            case NumericKind<?> _,ChoiceKind<
                    ?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.ProfileKind _,ValueKind.EnvironmentKind _ ->
                    Stream.empty();
        };
    }

    /** Returns the message for a dependent without an image. */
    String missingMessage(String dependent) {
        return dependent + " needs a " + name + ", found none";
    }
}
