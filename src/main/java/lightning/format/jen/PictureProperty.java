package lightning.format.jen;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.scene.Attribute;
import lightning.scene.Choice;
import lightning.scene.LightAttribute;
import lightning.scene.MaterialAttribute;
import lightning.scene.Quantity;
import lightning.scene.SampleMeaning;
import lightning.scene.ValueKind;

/**
 * A property that names the file of a picture.
 *
 * @param repeat  the property beside it that says how often the picture repeats; empty where there is none
 * @param samples what the file's samples stand for
 */
record PictureProperty(String name, Optional<String> repeat, SampleMeaning samples) {
    /** All that there are, of all blocks: no two have the same name. */
    static final List<PictureProperty> ALL = Stream.concat(MaterialAttribute.ALL.stream(), LightAttribute.ALL.stream())
            .flatMap(PictureProperty::of).toList();

    private static Stream<PictureProperty> of(Attribute<?, ?> attribute) {
        return switch (attribute.kind()) {
            case ValueKind.Texturing t -> Stream.of(new PictureProperty(attribute.name(), Optional.of(t.repeat()), t.samples()));
            case ValueKind.Projecting _ -> Stream.of(new PictureProperty(attribute.name(), Optional.empty(), SampleMeaning.COLOR));
            case Quantity<?> _,Choice<?> _,ValueKind.Linking _,ValueKind.Naming _,ValueKind.Shining _,ValueKind.Surrounding _ ->
                    Stream.empty();
        };
    }

    /** Why how often it repeats may not be said where there is no picture. */
    String missing() {
        return repeat.orElseThrow() + " needs a " + name + ", found none";
    }
}
