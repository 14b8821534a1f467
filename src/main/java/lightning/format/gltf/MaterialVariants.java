package lightning.format.gltf;

import java.util.ArrayList;
import java.util.List;
import lightning.base.text.Quote;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.MeshException;

/** Variants of a file's materials (KHR_materials_variants): named choices of other materials for some primitives. */
public final class MaterialVariants {
    private static final String EXTENSION = "KHR_materials_variants";
    /** Maximum number of names in messages. */

    private final GltfFile file;
    private final List<String> names;
    /** Index of the chosen variant; −1 for the file's own materials. */
    private final int chosen;

    /**
     * Chooses a variant.
     *
     * @param variant name of the variant; empty for the file's own materials
     * @throws MeshException if the file has no such variant
     */
    public MaterialVariants(GltfFile file, String variant) throws MeshException {
        this.file = file;
        names = names(file);
        chosen = variant.isEmpty() ? -1 : names.indexOf(variant);
        if (!variant.isEmpty() && chosen < 0) {
            throw new MeshException(file.path(), "", "must have the variant " + Quote.of(variant) + " of its materials, has "
                    + (names.isEmpty() ? "none" : Quote.list(names)));
        }
    }

    private static List<String> names(GltfFile file) throws MeshException {
        List<String> names = new ArrayList<>();
        JsonValue variants = file.root().get("extensions").get(EXTENSION).get("variants");
        for (int i = 0; i < variants.size(); i++) {
            names.add(variants.element(i).get("name").text().orElse(""));
        }
        return List.copyOf(names);
    }

    /** Notes the names of the variants if there are any and none is chosen. */
    public void noteNames(ConversionNotes notes) {
        notes.add("variants of materials, imported with the file's own materials: " + Quote.list(names), chosen < 0 ? names.size() : 0);
    }

    /**
     * Returns a part with its material in the chosen variant.
     *
     * @param notes receives what is approximated
     */
    public GltfPart part(GltfPart part, ConversionNotes notes) throws MeshException {
        if (chosen < 0) {
            return part;
        }
        JsonValue mappings = file.array("meshes").element(part.mesh()).get("primitives").element(part.primitive()).get("extensions")
                .get(EXTENSION).get("mappings");
        for (int i = 0; i < mappings.size(); i++) {
            JsonValue variants = mappings.element(i).get("variants");
            for (int j = 0; j < variants.size(); j++) {
                if (variants.element(j).integer(0, names.size() - 1) == chosen) {
                    int material = mappings.element(i).get("material").index(file.array("materials"));
                    // The mesh has the coordinates that the material without variants needs.
                    notes.add("materials of a variant that place their textures otherwise, placed as without variants",
                            isPlacedAlike(part.material(), material) ? 0 : 1);
                    return new GltfPart(part.mesh(), part.primitive(), part.name(), material, part.triangles(), part.vertices());
                }
            }
        }
        return part;
    }

    private boolean isPlacedAlike(int material, int other) throws MeshException {
        return !TextureTransform.hasTexture(file, other)
                || TextureTransform.of(file, material).isSame(TextureTransform.of(file, other));
    }
}
