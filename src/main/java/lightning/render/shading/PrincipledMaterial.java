package lightning.render.shading;

import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * What an opaque principled material needs beside {@link ShadingMaterial}.
 *
 * @param roughness   of the surface below the coat, 0…1
 * @param nonmetalF0  largest channel of the reflectance of its nonmetal part at normal incidence
 * @param isSmooth    whether its surface reflects a mirrored ray
 * @param coat        coat; null for none
 * @param isCoatSmooth whether the coat reflects a mirrored ray
 */
public record PrincipledMaterial(float roughness, float nonmetalF0, boolean isSmooth, @Nullable Coat coat, boolean isCoatSmooth) {

    /** Returns the properties of a material; null if it is not principled or transparent. */
    public static @Nullable PrincipledMaterial of(Material m) {
        return !m.isPrincipled() ? null
                : new PrincipledMaterial((float) m.roughness(), (float) (m.f0() * m.specularTint().max()), m.isSmooth(),
                        m.coat().isVisible() ? m.coat() : null, m.hasSmoothCoat());
    }

    /** Returns whether it needs the color of a mirrored ray. */
    public boolean isMirror() {
        return isSmooth || isCoatSmooth;
    }
}
