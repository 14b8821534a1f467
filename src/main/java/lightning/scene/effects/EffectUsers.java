package lightning.scene.effects;

import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.text.Messages;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.light.Light;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Fog;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;

/**
 * Parts of a scene that contribute to its image.
 *
 * @param scene  the whole scene
 * @param shapes the placed shapes
 * @param lights the lights that illuminate any shape, with their groups applied
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

    /** Returns the names of matching lights. */
    Stream<String> lights(Predicate<Light> filter) {
        return lights.stream().filter(filter).map(Light::name);
    }

    /** Returns the names of lights with a gain other than 1 that applies to a shape which they illuminate. */
    Stream<String> gainedLights() {
        return lights(light -> light.influence().diffuse() != 1 || light.influence().specular() != 1 || gainsShape(light));
    }

    private boolean gainsShape(Light light) {
        ShapeGains gains = light.influence().gains();
        if (gains.isNone()) {
            return false;
        }
        short[] entries = scene.stage().gainEntries(gains.names());
        boolean[] lit = scene.stage().linkMask(light.illuminates());
        return IntStream.range(0, entries.length)
                .anyMatch(i -> entries[i] > 0 && gains.entries().get(entries[i] - 1).gain() != 1 && lit[i]);
    }

    /** Returns the file of the world's environment and the names of the domes that are on. */
    Stream<String> environments() {
        return Stream.concat(scene.world().environment().stream().map(Environment::file),
                scene.world().named().stream().filter(d -> d.on() && d.image().isPresent()).map(Dome::name));
    }

    /** Returns the names of light groups that change any light. */
    Stream<String> lightGroups() {
        return shapes.isEmpty() ? Stream.empty() : scene.lights().stream().filter(l -> !l.lightGroup().isEmpty())
                .filter(l -> !scene.rig().effectiveLight(l).equals(l.withLightGroup(""))).map(Light::lightGroup);
    }

    /** Returns the names of matching materials on lit shapes. */
    Stream<String> litMaterials(Predicate<Material> filter) {
        return lights.isEmpty() ? Stream.empty() : materials(filter);
    }

    /** Returns the names of matching materials on shapes. */
    Stream<String> materials(Predicate<Material> filter) {
        return shapes.stream().map(PlacedShape::material).filter(filter).map(Material::name);
    }

    /** Returns the names of materials with a reflective color, if reflections are traced. */
    Stream<String> mirrors() {
        return scene.picture().depth() == 0 ? Stream.empty() : materials(Material::isMirror);
    }

    /** Returns the maximum number of reflection and refraction bounces; 0 if no shape's material needs any. */
    int depth() {
        return shapes.stream().map(PlacedShape::material).anyMatch(Material::spawnsSecondaryRays) ? scene.picture().depth() : 0;
    }

    /** Returns the image, if its pixels have several samples. */
    Stream<String> supersampling() {
        return scene.picture().sampling().isSupersampled() ? Stream.of("picture") : Stream.empty();
    }

    /** Returns the aperture of the lens, if it blurs anything. */
    Stream<String> lens() {
        return scene.hasDepthOfField()
                ? Stream.of(Messages.tr("aperture {0}", SceneLimits.formatShort(scene.camera().lens().aperture()))) : Stream.empty();
    }

    /** Returns the settings of indirect light, if the image has it and shapes that it can light. */
    Stream<String> indirectLight() {
        return shapes.isEmpty() ? Stream.empty() : scene.picture().indirect().stream().map(IndirectSettings::label);
    }

    /** Returns the density of fog. */
    Stream<String> fog() {
        Fog fog = scene.world().fog();
        return fog.isPresent() ? Stream.of(Messages.tr("density {0}", SceneLimits.formatShort(fog.density()))) : Stream.empty();
    }

    /** Returns the names of shapes with lit vertex colors. */
    Stream<String> vertexColors() {
        return lights.isEmpty() ? Stream.empty() : shapes.stream()
                .filter(s -> s.shape().solid() instanceof Solid.TriangleMesh t && t.hasVertexColors() && !s.material().albedo().isBlack())
                .map(s -> s.shape().name());
    }

    /** Returns the names of shapes of a solid type. */
    Stream<String> shapes(Class<? extends Solid> type) {
        return shapes.stream().map(PlacedShape::shape).filter(s -> type.isInstance(s.solid())).map(Shape::name);
    }
}
