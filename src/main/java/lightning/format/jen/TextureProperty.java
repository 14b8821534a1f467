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
 * A property that names the file of a picture.
 *
 * @param repeatProperty  the property beside it that says how often the picture repeats; empty where there is none
 * @param samples what the file's samples stand for
 */
record TextureProperty(String name, Optional<String> repeatProperty, TextureUsage samples) {
    /** All that there are, of all blocks: no two have the same name. */
    static final List<TextureProperty> ALL = Stream.concat(MaterialAttribute.ALL.stream(), LightAttribute.ALL.stream())
            .flatMap(TextureProperty::of).toList();

    private static Stream<TextureProperty> of(SceneAttribute<?, ?> attribute) {
        return switch (attribute.kind()) {
            case ValueKind.TextureKind t -> Stream.of(new TextureProperty(attribute.name(), Optional.of(t.repeatName()), t.usage()));
            case ValueKind.GoboKind _ -> Stream.of(new TextureProperty(attribute.name(), Optional.empty(), TextureUsage.COLOR));
            case NumericKind<?> _,ChoiceKind<
                    ?> _,ValueKind.LinksKind _,ValueKind.NameKind _,ValueKind.ProfileKind _,ValueKind.EnvironmentKind _ ->
                    Stream.empty();
        };
    }

    /** Why how often it repeats may not be said where there is no picture. */
    String missingMessage() {
        return repeatProperty.orElseThrow() + " needs a " + name + ", found none";
    }
}
