package lightning.format.exchange.json;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.math.Rgb;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.material.ShadingModel;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Attributes as JSON, out and back. */
class AttributeJsonTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();

    @Property
    void principledMaterial_isEqualAfterJson(@ForAll @DoubleRange(min = 0, max = 1) double a,
            @ForAll @DoubleRange(min = 0, max = 1) double b,
            @ForAll @DoubleRange(min = 1, max = 4) double ior) throws Exception {
        Material paint =
                Material.of("paint").withModel(ShadingModel.PRINCIPLED).withBase(new Rgb(a, b, 0.5)).withMetalness(b).withRoughness(a)
                        .withF0(b).withSpecularTint(new Rgb(b, 1, a)).withCoat(new Coat(a, b, ior));
        ObjectNode out = JSON.createObjectNode();
        AttributeJson.write(out, paint, MaterialAttribute.ALL);
        Material back = AttributeJson.read(JSON.readTree(JSON.writeValueAsBytes(out)), Material.of("paint"), MaterialAttribute.ALL,
                (_, _) -> false, message -> {
                    throw new AssertionError(message);
                });
        assertThat(back).isEqualTo(paint);
    }
}
