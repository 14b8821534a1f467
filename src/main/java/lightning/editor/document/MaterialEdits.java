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
 * The edits of materials. Each is refused if there is no material of the name given, or if a value is out of its range.
 * Shapes that name none have the material {@code default}, which an edit adds to the scene where it has none of its own.
 */
public final class MaterialEdits {
    private MaterialEdits() {}

    /** The material of a shape, also one in a group; empty if there is no such shape. */
    public static Optional<Material> ofShape(Scene scene, String shape) {
        return scene.stage().node(shape).filter(Shape.class::isInstance).map(s -> scene.materialsByName().get(((Shape) s).material()));
    }

    /** Any edit of one material that keeps its name. */
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

    /** Another value of an attribute. */
    public static <V> EditOutcome set(Scene scene, String name, MaterialAttribute<V> attribute, V value) {
        return edit(scene, name, m -> attribute.with(m, value));
    }

    /**
     * Puts a picture on the surface; how often it repeats is kept.
     *
     * @param file   as a scene file names it
     * @param folder the folder of the scene file
     */
    public static EditOutcome setTexture(Scene scene, String name, MaterialAttribute<Optional<TextureMap>> attribute, String file,
            Path folder) {
        return EditOutcome.of(() -> PropertyEdit.setTexture(scene, name, attribute, file, folder));
    }
}
