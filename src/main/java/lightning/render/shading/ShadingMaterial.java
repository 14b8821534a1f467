package lightning.render.shading;

import lightning.render.trace.MaterialTable;
import lightning.render.trace.TexelColumns;

/**
 * Material properties as the {@link LightingEquation} needs them: red, green, blue each.
 *
 * @param bsdf        how it scatters light
 * @param diffuse     k<sub>diffuse</sub> before the texture
 * @param specular    k<sub>specular</sub>, or the part of F0 that no texture multiplies
 * @param texturedF0  the part of F0 that texels multiply; 0 without highlights of microfacets
 * @param reflective  k<sub>reflective</sub>
 * @param isTextured  true if its rows' texels multiply k<sub>diffuse</sub>
 * @param hasImage    true if an image is among these factors
 * @param texels      colors of images that its rows have
 * @param hasSpecular true if it has specular terms: k<sub>specular</sub> is above 0 in any channel, or it has microfacets
 */
public record ShadingMaterial(Bsdf bsdf, float[] diffuse, float[] specular, float[] texturedF0, float[] reflective, boolean isTextured,
        boolean hasImage, TexelColumns texels, boolean hasSpecular) {
    // Arrays in a record: written once by their creator, never after.

    /**
     * Returns whether light at the surface adds to its color. Without, as for plain glass, the color is only that of bounced rays:
     * all other terms are +0 and change no bit.
     */
    public boolean takesLight() {
        return !(bsdf instanceof Bsdf.Clear clear) || clear.body() > 0 || hasSpecular;
    }

    /** Returns the properties of material {@code m}. */
    public static ShadingMaterial of(MaterialTable t, int m) {
        return new ShadingMaterial(Bsdf.of(t.material(m)),
                new float[] {t.diffuse(m, 0), t.diffuse(m, 1), t.diffuse(m, 2)},
                new float[] {t.specular(m, 0), t.specular(m, 1), t.specular(m, 2)},
                new float[] {t.metalF0(m, 0), t.metalF0(m, 1), t.metalF0(m, 2)},
                new float[] {t.reflective(m, 0), t.reflective(m, 1), t.reflective(m, 2)},
                t.isTextured(m), t.texture(m) != null, t.texels(m), t.isSpecular(m));
    }
}
