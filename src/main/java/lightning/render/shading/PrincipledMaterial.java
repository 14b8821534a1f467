package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.PrincipledColors;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Properties of an opaque or frosted principled material in addition to {@link ShadingMaterial}.
 *
 * @param material    the material
 * @param roughness   of the surface below the coat, 0…1, before its map
 * @param nonmetalF0  largest channel of the reflectance of its nonmetal part at normal incidence
 * @param isSmooth    whether its surface reflects a mirrored ray
 * @param highlight   highlights below the coat; null if they are isotropic
 * @param coat        coat; null for none
 * @param isCoatSmooth whether the coat reflects a mirrored ray
 * @param hasRoughnessMap whether its rows differ in roughness
 * @param hasMetalnessMap whether its rows differ in metalness
 * @param colors      its colors at any metalness
 * @param sheen       fibers; null for none
 * @param passing     color of the light that passes a frosted one: red, green, blue; null for others
 */
public record PrincipledMaterial(Material material, float roughness, float nonmetalF0, boolean isSmooth,
        @Nullable AnisotropicHighlight highlight, @Nullable Coat coat,
        boolean isCoatSmooth, boolean hasRoughnessMap, boolean hasMetalnessMap, PrincipledColors colors,
        @Nullable SheenLayer sheen, float @Nullable [] passing) {

    /** Returns the properties of a material; null if it is not principled or clear. */
    public static @Nullable PrincipledMaterial of(Material m) {
        return !m.isPrincipled() ? null
                : new PrincipledMaterial(m, (float) m.roughness(), (float) (m.f0() * m.specularTint().max()), m.isSmooth(),
                        AnisotropicHighlight.of(m), m.coat().isVisible() ? m.coat() : null, m.hasSmoothCoat(),
                        m.surfaceMaps().roughness().isPresent(),
                        m.surfaceMaps().metalness().isPresent(), new PrincipledColors(m), SheenLayer.of(m),
                        m.isFrosted() ? ClearMaterialShader.channels(m.transmission().color()) : null);
    }

    /** Returns whether light passes it. */
    public boolean isFrosted() {
        return passing != null;
    }

    /** Returns whether it needs the color of a mirrored ray. */
    public boolean isMirror() {
        return isSmooth || isCoatSmooth;
    }

    /** Returns the roughness of a row below the coat, 0…1. */
    public float roughness(HitRows rows, int row) {
        return hasRoughnessMap ? (float) mappedRoughness(rows, row) : roughness;
    }

    /** Returns the width α of the highlights of a row below the coat; the material has a roughness map. */
    public double mappedAlpha(HitRows rows, int row) {
        return Material.alpha(mappedRoughness(rows, row));
    }

    private double mappedRoughness(HitRows rows, int row) {
        return material.mappedRoughness(requireNonNull(rows.texel(ColumnGroup.ROUGHNESS_TEXEL, 0))[row]);
    }
}
