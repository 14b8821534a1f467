package lightning.editor.document;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.UnaryOperator;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Scene;
import lightning.scene.Shape;
import lightning.scene.TextureMap;

/**
 * Edits of materials. Each is refused if the named material does not exist or a value is out of range. Shapes without a material use {@code
 * default}, which an edit adds to the scene if needed.
 */
public final class MaterialEdits {
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
            throw new IllegalArgumentException(Messages.tr("material {0} not found", Quote.of(name)));
        }
        return material;
    }

    /** Sets the value of an attribute. */
    public static <V> EditOutcome set(Scene scene, String name, MaterialAttribute<V> attribute, V value) {
        return edit(scene, name, m -> attribute.with(m, value));
    }

    /**
     * Applies a texture and keeps its tiling.
     *
     * @param file   path as written in the scene file
     * @param folder folder of the scene file
     */
    public static EditOutcome setTexture(Scene scene, String name, MaterialAttribute<Optional<TextureMap>> attribute, String file,
            Path folder) {
        return EditOutcome.of(() -> PropertyEdit.setTexture(scene, name, attribute, file, folder));
    }
}
