package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import lightning.base.math.Rgb;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import org.junit.jupiter.api.Test;

/** Objects that glow and become lights. */
class GlowingObjectTest {
    private static final Rgb GLOW = new Rgb(6, 3, 1);

    private static Shape ball(String name, String material) {
        return new Shape(Solid.SPHERE, name, material, Placement.IDENTITY);
    }

    private static Scene scene() {
        return new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT,
                List.of(Material.of("neon").withGlow(GLOW), Material.of("wall")),
                List.of(ball("sign", "neon"), new NodeGroup("shop", Placement.IDENTITY, List.of(ball("lamp", "neon"))),
                        ball("room", "wall")),
                List.of());
    }

    private static Rgb glow(Scene scene, String shape) {
        String material = ((Shape) scene.stage().node(shape).orElseThrow()).material();
        return scene.materialsByName().get(material).emission();
    }

    @Test
    void light_hasTheGlowOfItsObject() {
        Scene made = ObjectLight.make(scene(), "sign", "sign light");
        Light light = made.light("sign light").orElseThrow();
        assertThat(light.type()).isEqualTo(LightType.OBJECT);
        assertThat(light.emission().unit()).isEqualTo(IntensityUnit.NIT);
        assertThat(light.color().times(light.intensity())).isEqualTo(GLOW);
        assertThat(glow(made, "sign").r()).isCloseTo(GLOW.r(), within(1e-9));
        assertThat(glow(made, "sign").b()).isCloseTo(GLOW.b(), within(1e-9));
    }

    /** The bulb follows the light, so a shared material is copied. */
    @Test
    void sharedMaterial_staysWithOtherObjects() {
        Scene made = ObjectLight.make(scene(), "sign", "sign light");
        Scene dimmed = made.withLight(made.light("sign light").orElseThrow().withIntensity(0));
        assertThat(glow(dimmed, "sign")).isEqualTo(Rgb.BLACK);
        assertThat(glow(dimmed, "lamp")).isEqualTo(GLOW);
    }

    @Test
    void objectWithoutGlow_becomesBrighterThanWhite() {
        assertThat(glow(ObjectLight.make(scene(), "room", "room light"), "room").max()).isCloseTo(4, within(1e-9));
    }

    @Test
    void allGlowingObjects_becomeLights() {
        Scene made = ObjectLight.makeAll(scene());
        assertThat(made.lights()).extracting(Light::name).containsExactly("sign light", "lamp light");
        assertThat(ObjectLight.makeAll(made)).as("bulbs are lights already").isEqualTo(made);
    }

    @Test
    void group_isNoLight() {
        assertThatThrownBy(() -> ObjectLight.make(scene(), "shop", "l")).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there is no object 'shop'");
    }

    @Test
    void lightName_isUnusedAndShortEnough() {
        assertThat(ObjectLight.lightName(ObjectLight.make(scene(), "sign", "sign light"), "sign")).isEqualTo("sign light 2");
        assertThat(ObjectLight.lightName(scene(), "x".repeat(lightning.scene.value.SceneLimits.MAX_NAME)))
                .hasSizeLessThanOrEqualTo(lightning.scene.value.SceneLimits.MAX_NAME);
    }
}
