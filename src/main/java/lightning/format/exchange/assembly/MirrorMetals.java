package lightning.format.exchange.assembly;

import lightning.format.mesh.ConversionNotes;
import lightning.scene.material.Material;

/** Imported metals that reflect other shapes. */
public final class MirrorMetals {
    /**
     * Roughness above which a reflection is blurred by more than 3° to each side, where the GGX highlight has half its
     * height.
     */
    public static final double MAX_ROUGHNESS = 0.2;

    private MirrorMetals() {}

    /**
     * Adds reflections to a metal that is fully metallic and smooth enough for sharp ones. Each pixel of such a surface
     * casts up to one ray per reflection bounce, and {@code reflective} supports no texture and weakens emission, so all
     * other metals reflect lights only.
     */
    public static Material reflect(Material material, ConversionNotes notes) {
        boolean isMirror = material.metalness() == 1 && material.roughness() <= MAX_ROUGHNESS && material.texture().isEmpty()
                && material.glow().isBlack();
        notes.add("metals that reflect only lights (rough, partly metallic, textured or emissive)",
                material.metalness() > 0 && !isMirror ? 1 : 0);
        return isMirror ? material.withReflective(material.base()) : material;
    }
}
