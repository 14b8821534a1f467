package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import lightning.base.math.Rgb;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.paper.CameraFraming;
import lightning.scene.value.Attenuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that scenes have the objects that the paper lists (§4 and appendix B). */
class PaperScenesTest {
    @ParameterizedTest
    @CsvSource({"bird, 4, 2, 4, 1", "balls, 4, 0, 0, 1", "spaceship, 0, 1, 11, 8",
        "desk, 1, 2, 16, 44", "house, 1, 2, 266, 1"})
    void scene_hasShapeCountsOfPaper(String name, int spheres, int cones, int cylinders, int planes) {
        List<Shape> shapes = SceneFiles.read(name).placedShapes().stream().map(PlacedShape::shape).toList();

        assertThat(count(shapes, Solid.Sphere.class)).as("spheres").isEqualTo(spheres);
        assertThat(count(shapes, Solid.Cone.class)).as("cones").isEqualTo(cones);
        assertThat(count(shapes, Solid.Cylinder.class)).as("cylinders").isEqualTo(cylinders);
        assertThat(count(shapes, Solid.Plane.class)).as("planes").isEqualTo(planes);
    }

    private static long count(List<Shape> shapes, Class<? extends Solid> kind) {
        return shapes.stream().map(Shape::solid).filter(kind::isInstance).count();
    }

    @ParameterizedTest
    @CsvSource({"bird, 1, 1, 1", "balls, 1, 1, 2", "spaceship, 2, 1, 1", "desk, 2, 1, 1", "house, 1, 1, 2"})
    void scene_hasLightCountsOfPaper(String name, int points, int spots, int directionals) {
        Map<LightType, Long> lights = SceneFiles.read(name).lights().stream()
                .collect(Collectors.groupingBy(Light::type, Collectors.counting()));

        assertThat(lights).containsExactlyInAnyOrderEntriesOf(Map.of(LightType.POINT, (long) points,
                LightType.SPOT, (long) spots, LightType.DIRECTIONAL, (long) directionals));
    }

    @Test
    void orange_hasTheNineLightsOfFigure3() {
        assertThat(SceneFiles.read("orange").lights()).hasSize(9);
    }

    @Test
    void night_hasThirtyLightsOfAllTypesOfThePaper() {
        Scene night = SceneFiles.read("night");

        assertThat(night.lights()).hasSize(30);
        assertThat(night.lights()).extracting(Light::type).contains(LightType.POINT, LightType.SPOT, LightType.DIRECTIONAL);
    }

    @Test
    void nightStreet_reflectsItsSurroundings() {
        PlacedShape street = SceneFiles.read("night").placedShapes().stream()
                .filter(p -> p.shape().name().equals("street")).findFirst().orElseThrow();

        assertThat(street.material().isPrincipled()).isTrue();
        assertThat(street.material().coat().isVisible()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"bird", "balls", "spaceship", "desk", "house", "orange", "night"})
    void everyLight_shines(String name) {
        Scene scene = SceneFiles.read(name);

        assertThat(scene.lights()).allMatch(l -> scene.isActive(l) && l.intensity() > 0 && !l.color().isBlack());
    }

    @Test
    void birdFeet_onlyHaveNoAmbientColor() {
        for (PlacedShape placed : SceneFiles.read("bird").placedShapes()) {
            boolean isFoot = placed.shape().name().startsWith("foot_") || placed.shape().name().startsWith("leg_");
            assertThat(placed.material().ambient().isBlack()).as(placed.shape().name()).isEqualTo(isFoot);
        }
    }

    @Test
    void birdFloor_isMirror() {
        PlacedShape floor = SceneFiles.read("bird").placedShapes().stream()
                .filter(p -> p.shape().solid() instanceof Solid.Plane).findFirst().orElseThrow();

        assertThat(floor.material().reflective().min()).isGreaterThan(0.1);
    }

    @Test
    void birdLights_havePrintedValues() {
        Scene bird = SceneFiles.read("bird");
        Light point = first(bird, LightType.POINT);
        CameraFraming framing = CameraFraming.of(bird.camera());

        assertThat(point.attenuation()).isEqualTo(new Attenuation(0.1, 1, 0.1));
        assertThat(point.position().minus(framing.focus()).dot(framing.right())).as("left of the bird").isNegative();
        assertThat(point.position().minus(framing.focus()).dot(framing.up())).as("above the bird").isPositive();
        assertThat(first(bird, LightType.DIRECTIONAL).color()).isEqualTo(Rgb.WHITE);
        assertThat(bird.world().ambience()).isEqualTo(1);
        assertThat(bird.picture().width()).isEqualTo(300);
        assertThat(bird.picture().height()).isEqualTo(300);
    }

    private static Light first(Scene scene, LightType type) {
        return scene.lights().stream().filter(l -> l.type() == type).findFirst().orElseThrow();
    }
}
