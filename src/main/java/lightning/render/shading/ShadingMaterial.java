package lightning.render.shading;

import lightning.render.trace.MaterialTable;
import lightning.render.trace.TexelColumns;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Material properties as the {@link LightingEquation} needs them: red, green, blue each.
 *
 * @param ambient      k<sub>ambient</sub> before the scene's ambience
 * @param glow         light that the surface emits itself, before its glow map
 * @param diffuse      k<sub>diffuse</sub> before the texture
 * @param specular     k<sub>specular</sub>, or the part of F0 that no texture multiplies
 * @param texturedF0   the part of F0 that texels multiply; null if the material is not metallic
 * @param principled   further properties of a principled material; null for others
 * @param reflective   k<sub>reflective</sub>
 * @param clarity      transmission; null if the material is opaque
 * @param interior     tint of paths inside; null if the material is opaque
 * @param bodyShare    body share of a clear surface
 * @param isTextured   true if its rows' texels multiply k<sub>diffuse</sub>
 * @param hasImage     true if an image is among these factors
 * @param texels       colors of images that its rows have
 * @param hasSpecular  true if it has specular terms: k<sub>specular</sub> is above 0 in any channel, or the material is metallic
 * @param isReflective true if k<sub>reflective</sub> is above 0 in any channel
 */
public record ShadingMaterial(float[] ambient, float[] glow, float[] diffuse, float[] specular, float @Nullable [] texturedF0,
        @Nullable PrincipledMaterial principled, float[] reflective, @Nullable Transmission clarity, @Nullable InteriorTint interior,
        float bodyShare, boolean isTextured,
        boolean hasImage,
        TexelColumns texels,
        boolean hasSpecular,
        boolean isReflective) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Returns whether light at the surface adds to its color. Without, as for plain glass, the color is only that of bounced rays:
     * all other terms are +0 and change no bit.
     */
    public boolean takesLight() {
        return clarity == null || bodyShare > 0 || hasSpecular;
    }

    /** Returns the properties of material {@code m}. */
    public static ShadingMaterial of(MaterialTable t, int m) {
        float[] reflective = {t.reflective(m, 0), t.reflective(m, 1), t.reflective(m, 2)};
        return new ShadingMaterial(new float[] {t.ambient(m, 0), t.ambient(m, 1), t.ambient(m, 2)},
                new float[] {t.glow(m, 0), t.glow(m, 1), t.glow(m, 2)},
                new float[] {t.diffuse(m, 0), t.diffuse(m, 1), t.diffuse(m, 2)},
                new float[] {t.specular(m, 0), t.specular(m, 1), t.specular(m, 2)},
                t.isMetallic(m) ? new float[] {t.metalF0(m, 0), t.metalF0(m, 1), t.metalF0(m, 2)} : null,
                PrincipledMaterial.of(t.material(m)), reflective,
                t.isClear(m) ? t.transmission(m) : null, t.isClear(m) ? new InteriorTint(t.transmission(m)) : null,
                SurfaceFactors.bodyShare(t.transmission(m)), t.isTextured(m),
                t.texture(m) != null,
                t.texels(m),
                t.isSpecular(m),
                reflective[0] > 0 || reflective[1] > 0 || reflective[2] > 0);
    }
}
