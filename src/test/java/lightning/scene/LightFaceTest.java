package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Emission;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Shapes and colors of visible lights. */
class LightFaceTest {
    private static final Light SOFTBOX = Light.of("key", LightType.RECT).withPosition(new Vec3(1, 2, 3))
            .withArea(new AreaShape(0.5, 0, 2, 3, Vec3.Y, 16).withVisibility(FaceVisibility.GLOWING));

    private static Rgb glow(Light light, double meters) {
        LightRig rig = LightRig.of(List.of(light)).withEnvironments(List.of(), meters);
        return LightFace.of(rig, 0, Set.of()).getFirst().material().emission();
    }

    private static List<LightFace> faces(Light... lights) {
        return LightFace.of(LightRig.of(List.of(lights)), 0, Set.of());
    }

    @ParameterizedTest
    @EnumSource(value = LightType.class, names = {"DIRECTIONAL", "OBJECT"}, mode = EnumSource.Mode.EXCLUDE)
    void nits_areTheValueOfTheFace(LightType type) {
        for (Falloff falloff : Falloff.values()) {
            Light light = SOFTBOX.withType(type).withFalloff(falloff).withIntensity(7)
                    .withEmission(Emission.DEFAULT.withUnit(IntensityUnit.NIT).withExposure(1));
            assertThat(glow(light, 0.01).r()).isCloseTo(14, within(1e-12));
        }
    }

    /** A lamp of 100 candela and 2 m × 3 m has 100 / 6 nits. */
    @Test
    void inverseSquareLight_hasItsIntensityPerArea() {
        Light light = SOFTBOX.withFalloff(Falloff.INVERSE_SQUARE).withIntensity(100)
                .withEmission(Emission.DEFAULT.withUnit(IntensityUnit.CANDELA));
        assertThat(glow(light, 1).g()).isCloseTo(100 / 6.0, within(1e-12));
        Light ball = light.withType(LightType.POINT);
        assertThat(glow(ball, 1).g()).isCloseTo(100 / (Math.PI * 0.25), within(1e-10));
    }

    @Test
    void lightOfCustomFalloff_hasItsWeight() {
        assertThat(glow(SOFTBOX.withIntensity(3).withColor(new Rgb(1, 0.5, 0)), 1)).isEqualTo(new Rgb(3, 1.5, 0));
    }

    @Test
    void texture_multipliesTheGlow_alsoOfADarkLight() {
        Texture image = new Texture(2, 1, new float[] {1, 0, 0.5f, 0, 0, 0.5f});
        Light light = SOFTBOX.withIntensity(4).withTexture(Optional.of(new LightTexture("t.png", image)));
        Material face = faces(light).getFirst().material();
        assertThat(face.bulb()).isEqualTo(new Bulb(light.name(), 0, Rgb.gray(4), Rgb.gray(1)));
        assertThat(face.glowMap().orElseThrow().image()).isSameAs(image);
        assertThat(faces(light.withOn(false)).getFirst().material()).isEqualTo(face.withBulb(face.bulb().withGlow(Rgb.BLACK)));
    }

    @Test
    void glowTimesTexture_isLimited() {
        Texture image = new Texture(1, 1, new float[] {1000, 0, 0});
        Light light = SOFTBOX.withIntensity(1e5).withTexture(Optional.of(new LightTexture("t.hdr", image)));
        assertThat(glow(light, 1).r()).isCloseTo(SceneLimits.MAX_EMISSION / 1000, within(1e-9));
    }

    @Test
    void glow_isLimited() {
        assertThat(glow(SOFTBOX.withIntensity(1e30), 1)).isEqualTo(Rgb.gray(SceneLimits.MAX_EMISSION));
    }

    @Test
    void darkLight_hasABlackFace() {
        assertThat(glow(SOFTBOX.withOn(false), 1)).isEqualTo(Rgb.BLACK);
        assertThat(faces(SOFTBOX, Light.of("fill", LightType.POINT).withSolo(true)).getFirst().material().emission()).isEqualTo(Rgb.BLACK);
    }

    @Test
    void lightsWithoutSize_haveNoFace() {
        AreaShape flat = SOFTBOX.area().withHeight(0).withRadius(0);
        assertThat(faces(SOFTBOX.withArea(flat))).isEmpty();
        assertThat(faces(SOFTBOX.withArea(flat).withType(LightType.SPOT))).isEmpty();
        assertThat(faces(SOFTBOX.withType(LightType.DIRECTIONAL))).isEmpty();
        assertThat(faces(SOFTBOX.withArea(SOFTBOX.area().withVisibility(FaceVisibility.HIDDEN)))).isEmpty();
    }

    @Property
    void rotation_mapsTheAxes(@ForAll @DoubleRange(min = -1, max = 1) double x, @ForAll @DoubleRange(min = -1, max = 1) double y,
            @ForAll @DoubleRange(min = -1, max = 1) double z) {
        Vec3 axis = new Vec3(x, y, z).maxAbs() < 1e-6 ? Vec3.Y : new Vec3(x, y, z).normalized();
        Vec3 right = AreaShape.DEFAULT.right(axis);
        Transform rotation = Transform.rotation(LightFace.rotation(right, axis));
        assertThat(rotation.transformVector(new Vec3(1, 0, 0)).minus(right).maxAbs()).isLessThan(1e-8);
        assertThat(rotation.transformVector(Vec3.Y).minus(axis).maxAbs()).isLessThan(1e-8);
    }

    @Test
    void materials_haveNamesOfTheirOwn() {
        String longName = "n".repeat(SceneLimits.MAX_NAME);
        List<LightFace> faces = LightFace.of(LightRig.of(List.of(SOFTBOX, SOFTBOX.withName(longName), SOFTBOX.withName(longName.substring(1)
                + "x"))), 0, Set.of("light key"));
        assertThat(faces).extracting(face -> face.material().name()).doesNotHaveDuplicates().doesNotContain("light key")
                .allMatch(name -> name.length() <= SceneLimits.MAX_NAME);
    }

    @Test
    void fullStage_hasNoRoomForFaces() {
        assertThat(LightFace.of(LightRig.of(List.of(SOFTBOX)), SceneLimits.MAX_SHAPES, Set.of())).isEmpty();
    }

    @Test
    void faces_areRenderedButNotPartOfTheDocument() {
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(),
                List.of(new Shape(Solid.SPHERE, "ball", "default", Placement.IDENTITY)), List.of(SOFTBOX));
        assertThat(scene.stage().shapes()).extracting(Shape::name).containsExactly("ball");
        assertThat(scene.stage().hasNode("key")).isFalse();
        assertThat(scene.stage().rendered().shapes()).extracting(Shape::name).containsExactly("ball", "key");
        Stage dark = scene.withLights(List.of()).stage();
        assertThat(dark.rendered()).isSameAs(dark);
    }

    @Test
    void edits_keepTheOtherNodesOfTheRenderedStage() {
        Light second = SOFTBOX.withName("fill");
        Scene scene = new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(),
                List.of(new Shape(Solid.SPHERE, "ball", "default", Placement.IDENTITY)), List.of(SOFTBOX, second));
        Stage before = scene.stage().rendered();
        Stage moved = scene.withLight(second.withPosition(Vec3.Y)).stage().rendered();
        assertThat(moved.sharesStructure(before)).isTrue();
        assertThat(moved.nodes().get(2)).isNotEqualTo(before.nodes().get(2));
        assertThat(scene.withLight(second.withIntensity(2)).stage().rendered().hasSameNodes(before)).isTrue();
        Scene dragged = scene.replaceNode("ball", List.of(new Shape(Solid.CONE, "ball", "default", Placement.IDENTITY)));
        assertThat(dragged.stage().rendered().sharesStructure(before)).isTrue();
        assertThat(dragged.stage().rendered().shapes().getFirst().solid()).isEqualTo(Solid.CONE);
        assertThat(dragged.withLight(SOFTBOX.withPosition(Vec3.Y)).stage().rendered().sharesStructure(before)).isTrue();
        // Another material, then a shape that has it.
        Scene recolored = scene.withMaterials(List.of(Material.of("new")))
                .replaceNode("ball", List.of(new Shape(Solid.CONE, "ball", "new", Placement.IDENTITY)));
        assertThat(recolored.stage().rendered().sharesStructure(before)).isTrue();
        assertThat(recolored.stage().rendered().usedMaterials()).containsExactly("new", "light key", "light fill");
        Stage swapped = scene.withLights(List.of(second, SOFTBOX)).stage().rendered();
        assertThat(swapped.shapes()).extracting(Shape::name).containsExactly("ball", "fill", "key");
    }
}
