package lightning.render.shading;

import lightning.render.trace.PrincipledColors;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Properties of an opaque or frosted principled material in addition to {@link ShadingMaterial}.
 *
 * @param material    the material
 * @param isSmooth    whether its surface reflects a mirrored ray
 * @param highlight   highlights below the coat; null if they are isotropic
 * @param coat        coat; null for none
 * @param isCoatSmooth whether the coat reflects a mirrored ray
 * @param hasRoughnessMap whether its rows differ in roughness
 * @param hasCoatRoughnessMap whether its rows differ in the roughness of their coat
 * @param hasCoatNormals whether its coat has other normals than the surface
 * @param hasColorMap whether its rows differ in metalness, or in the reflectance of a nonmetal
 * @param colors      its colors at any metalness
 * @param sheen       fibers; null for none
 * @param passing     color of the light that passes a frosted one: red, green, blue; null for others
 */
public record PrincipledMaterial(Material material, boolean isSmooth, @Nullable AnisotropicHighlight highlight, @Nullable Coat coat,
        boolean isCoatSmooth, boolean hasRoughnessMap, boolean hasCoatRoughnessMap, boolean hasCoatNormals, boolean hasColorMap,
        PrincipledColors colors,
        @Nullable SheenLayer sheen, float @Nullable [] passing) {

    /** Returns the properties of a material; null if it is not principled or clear. */
    public static @Nullable PrincipledMaterial of(Material m) {
        return !m.isPrincipled() ? null
                : new PrincipledMaterial(m, m.isSmooth(), AnisotropicHighlight.of(m),
                        m.coat().isVisible() ? m.coat() : null, m.hasSmoothCoat(), m.surfaceMaps().roughness().isPresent(),
                        m.layerMaps().coatRoughness().isPresent(), m.hasCoatNormals(),
                        m.surfaceMaps().changeColors(), new PrincipledColors(m), SheenLayer.of(m),
                        m.isFrosted() ? LightWeight.channels(m.transmission().color()) : null);
    }

    /** Returns whether light passes it. */
    public boolean isFrosted() {
        return passing != null;
    }

    /** Returns whether it needs the color of a mirrored ray. */
    public boolean isMirror() {
        return isSmooth || isCoatSmooth;
    }
}
