package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.document.manipulation.ViewFocus;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;

class NewLightTest {
    private final Scene scene = DeskScene.scene();

    /** The end of a tube is dark, also where rounding makes the cosine to its axis larger than 1. */
    @Property
    void tubeSeenFromItsEnd_doesNotCount(@ForAll @DoubleRange(min = -5, max = 5) double x, @ForAll @DoubleRange(min = 1, max = 5) double y,
            @ForAll @DoubleRange(min = -5, max = 5) double z) {
        Vec3 away = new Vec3(x, y, z);
        Light tube = Light.of("tube", LightType.TUBE).withPosition(ViewFocus.of(scene).plus(away)).withDirection(away)
                .withArea(AreaShape.DEFAULT.withRadius(0.01)).withIntensity(1e-3);
        Light fill = DeskScene.light(scene, "fill").withOn(true).withSolo(false);
        Light without = NewLight.of(scene.withLights(List.of(fill)), LightType.POINT);
        Light with = NewLight.of(scene.withLights(List.of(fill, tube)), LightType.POINT);
        assertThat(with.emission()).isEqualTo(without.emission());
    }
}
