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
record EffectUsers(Scene scene, List<PlacedShape> shapes, List<Light> lights) {

    static EffectUsers of(Scene scene) {
        List<PlacedShape> shapes = scene.placedShapes();
        return new EffectUsers(scene, shapes,
                shapes.isEmpty() ? List.of() : scene.rig().effectiveLights().stream().filter(l -> contributes(scene, l)).toList());
    }

    private static boolean contributes(Scene scene, Light light) {
        return scene.isActive(light) && !light.weight().isBlack();
    }

    /** The names of such lights. */
    Stream<String> lights(Predicate<Light> filter) {
        return lights.stream().filter(filter).map(Light::name);
    }

    /** The names of banks that make any light another. */
    Stream<String> lightGroups() {
        return shapes.isEmpty() ? Stream.empty() : scene.lights().stream().filter(l -> !l.lightGroup().isEmpty())
                .filter(l -> !scene.rig().effectiveLight(l).equals(l.withLightGroup(""))).map(Light::lightGroup);
    }

    /** The names of such materials on shapes that are lit. */
    Stream<String> litMaterials(Predicate<Material> filter) {
        return lights.isEmpty() ? Stream.empty() : materials(filter);
    }

    /** The names of such materials on shapes. */
    Stream<String> materials(Predicate<Material> filter) {
        return shapes.stream().map(PlacedShape::material).filter(filter).map(Material::name);
    }

    /** The names of materials that mirror by their own color, where rays are followed. */
    Stream<String> mirrors() {
        return scene.picture().depth() == 0 ? Stream.empty() : materials(Material::isMirror);
    }

    /** How many times a ray can bounce at most, mirrored or refracted: 0 where no shape's material bounces rays. */
    int depth() {
        return shapes.stream().map(PlacedShape::material).anyMatch(Material::spawnsSecondaryRays) ? scene.picture().depth() : 0;
    }

    /** The picture, where its pixels have several samples. */
    Stream<String> supersampling() {
        return scene.picture().sampling().isSupersampled() ? Stream.of("picture") : Stream.empty();
    }

    /** The names of shapes whose vertices' colors are lit. */
    Stream<String> vertexColors() {
        return lights.isEmpty() ? Stream.empty() : shapes.stream()
                .filter(s -> s.shape().solid() instanceof Solid.TriangleMesh t && t.hasVertexColors() && !s.material().albedo().isBlack())
                .map(s -> s.shape().name());
    }

    /** The names of shapes of such a form. */
    Stream<String> shapes(Class<? extends Solid> type) {
        return shapes.stream().map(PlacedShape::shape).filter(s -> type.isInstance(s.solid())).map(Shape::name);
    }
}
