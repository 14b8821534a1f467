package lightning.document;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.Emission;
import lightning.scene.light.LightType;
import lightning.scene.material.Bulb;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.Shape;

/**
 * Edits of materials. Each is refused if the named material does not exist or a value is out of range. Shapes without a material use {@code
 * default}, which an edit adds to the scene if needed.
 */
public final class MaterialEdits {
    /** Linear value of a new bulb's brightest channel. */
    private static final double INITIAL_BULB_BRIGHTNESS = 4;

    private MaterialEdits() {}

    /** Returns the material of a shape, including shapes in groups; empty if the shape does not exist. */
    public static Optional<Material> ofShape(Scene scene, String shape) {
        return scene.stage().node(shape).filter(Shape.class::isInstance).map(s -> scene.materialsByName().get(((Shape) s).material()));
    }

    /** Edits one material, keeping its name. */
    public static EditOutcome edit(Scene scene, String name, UnaryOperator<Material> edit) {
        return EditOutcome.of(() -> scene.withMaterial(edit.apply(material(scene, name))));
    }

    private static Material material(Scene scene, String name) {
        Material material = scene.materialsByName().get(name);
        if (material == null) {
            throw new RefusalException(Messages.tr("material {0} not found", Quote.of(name)));
        }
        return material;
    }

    /** Sets the value of an attribute. */
    public static <V> EditOutcome set(Scene scene, String name, MaterialAttribute<V> attribute, V value) {
        return edit(scene, name, m -> attribute.with(m, value));
    }

    /**
     * Makes a material the bulb of a light. An exposure that was never set becomes one that makes the bulb two stops brighter than white, whatever
     * the light's intensity.
     *
     * @param light name of a light; empty for none
     */
    public static EditOutcome setBulb(Scene scene, String name, String light) {
        return edit(scene, name, m -> {
            double weight = scene.light(light).map(l -> scene.rig().effectiveLight(l).weight().max()).orElse(0.0);
            // The bulb of an object's light has the radiance of the light.
            boolean isObject = scene.light(light).filter(l -> l.type() == LightType.OBJECT).isPresent();
            boolean isInitial = m.bulb().exposure() == Bulb.NONE.exposure() && weight > 0 && !isObject;
            Material bulb = MaterialAttribute.BULB.with(m, light);
            return isInitial ? MaterialAttribute.BULB_EXPOSURE.with(bulb, exposure(weight)) : bulb;
        });
    }

    private static double exposure(double weight) {
        double tenths = Math.rint(10 * Math.log(INITIAL_BULB_BRIGHTNESS / weight) / Math.log(2));
        return Math.clamp(tenths / 10, -Emission.MAX_EXPOSURE, Emission.MAX_EXPOSURE) + 0.0;
    }

    /**
     * Applies a texture and keeps its tiling.
     *
     * @param file   path as written in the scene file
     * @param folder folder of the scene file
     */
    public static EditOutcome setTexture(Scene scene, String name, MaterialAttribute<Optional<TextureMap>> attribute, String file,
            Path folder) {
        return EditOutcome.of(() -> PropertyEdit.setFile(scene, new SceneElement.OfMaterial(name), attribute.name(), file, folder));
    }
}
