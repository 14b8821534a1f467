package lightning.format.jen;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.scene.ChoiceKind;
import lightning.scene.LightAttribute;
import lightning.scene.MaterialAttribute;
import lightning.scene.NumericKind;
import lightning.scene.SceneAttribute;
import lightning.scene.TextureUsage;
import lightning.scene.ValueKind;

/**
 * Property that references an image file.
 *
 * @param repeatProperty property with the image's repeat; empty if there is none
 * @param samples meaning of the samples
 */
record TextureProperty(String name, Optional<String> repeatProperty, TextureUsage samples) {
    /** All image properties of all blocks; their names are unique. */
    static final List<TextureProperty> ALL = Stream.concat(MaterialAttribute.ALL.stream(), LightAttribute.ALL.stream())
            .flatMap(TextureProperty::of).toList();

    private static Stream<TextureProperty> of(SceneAttribute<?, ?> attribute) {
        return switch (attribute.kind()) {
            case ValueKind.TextureKind t -> Stream.of(new TextureProperty(attribute.name(), Optional.of(t.repeatName()), t.usage()));
            case ValueKind.GoboKind _ -> Stream.of(new TextureProperty(attribute.name(), Optional.empty(), TextureUsage.COLOR));
            case NumericKind<?> _,ChoiceKind<
                    ?> _,ValueKind.LinksKind _,ValueKind.GainsKind _,ValueKind.NameKind _,ValueKind.ProfileKind _,ValueKind.EnvironmentKind _ ->
                    Stream.empty();
        };
    }

    /** Returns the message for a repeat without an image. */
    String missingMessage() {
        return repeatProperty.orElseThrow() + " needs a " + name + ", found none";
    }
}
