package lightning.format.jen;

import java.util.List;
import java.util.stream.Stream;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;

/** Remarks about properties that are set and have no effect, such as the position of a directional light. */
public final class InertProperties {
    private InertProperties() {}

    /** Returns a clause for each such property, such as {@code sun.at has no effect: a directional light has no position}. */
    public static List<String> of(Scene scene) {
        return scene.lights().stream().flatMap(InertProperties::of).toList();
    }

    private static Stream<String> of(Light light) {
        BlockContent content = BlockContent.of(light);
        return LightAttribute.ALL.stream()
                .filter(attribute -> BlockTypes.LIGHT.property(attribute.name()).filter(content::mustWrite).isPresent())
                .flatMap(attribute -> attribute.inactiveReason(light).stream()
                        .map(reason -> NameSyntax.format(light.name()) + "." + attribute.name() + " has no effect: " + reason));
    }
}
