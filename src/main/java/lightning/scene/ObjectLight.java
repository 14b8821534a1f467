package lightning.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import lightning.base.math.Rgb;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.scene.light.AreaShape;
import lightning.scene.light.Emission;
import lightning.scene.light.Falloff;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.value.SceneLimits;

/** Changes of glowing shapes to lights. */
public final class ObjectLight {
    /** Value of the glow of a shape that did not glow: two stops brighter than white. */
    private static final double INITIAL_GLOW = 4;

    /** Code points of a name that leave room for a word and a number. */
    private static final int MAX_STEM = SceneLimits.MAX_NAME - 16;

    private ObjectLight() {}

    /**
     * Returns a scene in which a shape is a light with the glow that the shape has; of a shape without a glow two stops brighter than white. Its
     * material, or a copy if other shapes have it too, becomes the bulb of the light.
     *
     * @param light name of the new light
     * @throws RefusalException if there is no such shape, or if the name is taken
     */
    public static Scene make(Scene scene, String shape, String light) {
        if (!(scene.stage().node(shape).orElse(null) instanceof Shape found)) {
            throw new RefusalException("there is no object " + Quote.of(shape));
        }
        Material material = scene.materialsByName().getOrDefault(found.material(), Material.DEFAULT);
        Rgb glow = material.glow().isBlack() ? Rgb.gray(INITIAL_GLOW) : material.glow();
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(Light.of(light, LightType.OBJECT).withFalloff(Falloff.INVERSE_SQUARE).withColor(glow.times(1 / glow.max()))
                .withIntensity(glow.max()).withEmission(Emission.DEFAULT.withUnit(IntensityUnit.NIT))
                .withArea(AreaShape.DEFAULT.withShape(shape)));
        return withBulb(scene, found, light).withLights(lights);
    }

    /**
     * Returns a scene in which every shape whose material glows, and is no bulb, is a light, as long as there is room for lights and materials.
     */
    public static Scene makeAll(Scene scene) {
        Scene made = scene;
        for (Shape shape : scene.stage().shapes()) {
            Material material = scene.materialsByName().getOrDefault(shape.material(), Material.DEFAULT);
            boolean hasRoom =
                    made.lights().size() < SceneLimits.MAX_LIGHTS && made.materials().size() < SceneLimits.MAX_MATERIALS;
            if (hasRoom && !material.glow().isBlack() && material.bulb().light().isEmpty()) {
                made = make(made, shape.name(), lightName(made, shape.name()));
            }
        }
        return made;
    }

    /** Returns a scene in which a shape shows the glow of a light. */
    public static Scene withBulb(Scene scene, Shape shape, String light) {
        boolean isOwn = scene.material(shape.material()).isPresent() && users(scene.nodes(), shape.material()) == 1;
        Material material = scene.materialsByName().getOrDefault(shape.material(), Material.DEFAULT);
        Material bulb = material
                .withName(isOwn ? material.name() : unused(stem(material.name() + " " + light), scene.materialsByName()::containsKey))
                .withGlow(Rgb.BLACK).withBulb(Bulb.NONE.withLight(light));
        List<Material> materials = new ArrayList<>(scene.materials());
        if (isOwn) {
            materials.replaceAll(m -> m.name().equals(bulb.name()) ? bulb : m);
        } else {
            materials.add(bulb);
        }
        Scene made = scene.withStage(scene.stage().withMaterials(materials));
        return made.withNode(shape.name(), shape.withMaterial(bulb.name()));
    }

    /** Returns an unused name for the light of a shape. */
    public static String lightName(Scene scene, String shape) {
        return unused(stem(shape) + " light", scene::isNameUsed);
    }

    private static String stem(String name) {
        return name.substring(0, name.offsetByCodePoints(0, Math.min(name.codePointCount(0, name.length()), MAX_STEM)));
    }

    private static String unused(String wanted, Predicate<String> isUsed) {
        String name = wanted;
        for (int n = 2; isUsed.test(name); n++) {
            name = wanted + " " + n;
        }
        return name;
    }

    private static long users(List<SceneNode> nodes, String material) {
        return nodes.stream().mapToLong(node -> switch (node) {
            case NodeGroup group -> users(group.children(), material);
            case Shape shape -> shape.material().equals(material) ? 1 : 0;
        }).sum();
    }
}
