package lightning.scene.effects;

import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import lightning.scene.Light;
import lightning.scene.Material;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.Solid;

/**
 * What of a scene takes part in its picture.
 *
 * @param scene  all of it
 * @param shapes the shapes
 * @param lights the lights that shine on any, as their banks make them
 */
record Uses(Scene scene, List<PlacedShape> shapes, List<Light> lights) {

    static Uses of(Scene scene) {
        List<PlacedShape> shapes = scene.placedShapes();
        return new Uses(scene, shapes,
                shapes.isEmpty() ? List.of() : scene.rig().actingLights().stream().filter(l -> shines(scene, l)).toList());
    }

    private static boolean shines(Scene scene, Light light) {
        return scene.shines(light) && !light.weight().isBlack();
    }

    /** The names of such lights. */
    Stream<String> lights(Predicate<Light> which) {
        return lights.stream().filter(which).map(Light::name);
    }

    /** The names of banks that make any light another. */
    Stream<String> banks() {
        return shapes.isEmpty() ? Stream.empty() : scene.lights().stream().filter(l -> !l.bank().isEmpty())
                .filter(l -> !scene.rig().acting(l).equals(l.withBank(""))).map(Light::bank);
    }

    /** The names of such materials on shapes that are lit. */
    Stream<String> litMaterials(Predicate<Material> which) {
        return lights.isEmpty() ? Stream.empty() : materials(which);
    }

    /** The names of such materials on shapes. */
    Stream<String> materials(Predicate<Material> which) {
        return shapes.stream().map(PlacedShape::material).filter(which).map(Material::name);
    }

    /** The names of materials that mirror by their own color, where rays are followed. */
    Stream<String> mirrors() {
        return scene.picture().depth() == 0 ? Stream.empty() : materials(Material::isMirror);
    }

    /** How many times a ray can bounce at most, mirrored or refracted: 0 where no shape's material bounces rays. */
    int depth() {
        return shapes.stream().map(PlacedShape::material).anyMatch(Material::bouncesRays) ? scene.picture().depth() : 0;
    }

    /** The picture, where its pixels have several samples. */
    Stream<String> fineSamples() {
        return scene.picture().sampling().isFine() ? Stream.of("picture") : Stream.empty();
    }

    /** The names of shapes whose vertices' colours are lit. */
    Stream<String> tints() {
        return lights.isEmpty() ? Stream.empty() : shapes.stream()
                .filter(s -> s.shape().solid() instanceof Solid.Triangles t && t.isTinted() && !s.material().body().isBlack())
                .map(s -> s.shape().name());
    }

    /** The names of shapes of such a form. */
    Stream<String> shapes(Class<? extends Solid> type) {
        return shapes.stream().map(PlacedShape::shape).filter(s -> type.isInstance(s.solid())).map(Shape::name);
    }
}
