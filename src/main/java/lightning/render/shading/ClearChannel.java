package lightning.render.shading;

import static java.util.Objects.requireNonNull;

/**
 * Factors of one color channel of a clear material, as {@link LightingEquation#clearColor} needs them.
 *
 * @param emitted    {@link EmittedLight#unmapped}
 * @param diffuse    k<sub>diffuse</sub> before the texture
 * @param specular   k<sub>specular</sub>, or the part of F0 that no texture multiplies
 * @param texturedF0 the part of F0 that texels multiply; 0 if the material is not metallic
 * @param reflective k<sub>reflective</sub>
 * @param body       body share
 * @param clear      transmission color
 */
public record ClearChannel(float emitted, float diffuse, float specular, float texturedF0, float reflective, float body, float clear) {

    /** Returns the factors of channel {@code c} of a material. */
    static ClearChannel of(ShadingMaterial material, int c, float emitted) {
        float[] f0 = material.texturedF0();
        return new ClearChannel(emitted, material.diffuse()[c], material.specular()[c], f0 == null ? 0 : f0[c], material.reflective()[c],
                material.bodyShare(),
                ClearMaterialShader.channel(requireNonNull(material.clarity()).color(), c));
    }
}
