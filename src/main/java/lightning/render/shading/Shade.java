package lightning.render.shading;

import lightning.render.trace.MaterialTable;
import lightning.scene.Clarity;

/**
 * What a material shows of the light that falls on it, as the {@link LightingEquation} needs it: red, green, blue each.
 *
 * @param ambient    k<sub>ambient</sub> before the scene's ambience
 * @param diffuse    k<sub>diffuse</sub> before the texture
 * @param specular   k<sub>specular</sub>, or the part of F0 that no texture multiplies
 * @param metal      the part of F0 that texels multiply; null where the material is not metallic
 * @param reflective k<sub>reflective</sub>
 * @param clarity    what passes through; null where nothing does
 * @param body       how much of a clear surface is body
 * @param textured   whether its rows' texels are factors of k<sub>diffuse</sub>
 * @param pictured   whether a picture is among these factors
 * @param shines     whether it has specular terms: k<sub>specular</sub> is above 0 in any channel, or the material is metallic
 * @param mirrors    whether k<sub>reflective</sub> is above 0 in any channel
 */
public record Shade(float[] ambient, float[] diffuse, float[] specular, float[] metal, float[] reflective, Clarity clarity, float body,
        boolean textured,
        boolean pictured,
        boolean shines,
        boolean mirrors) {
    // Arrays in a record: written once by their maker, never after.

    /** That of material {@code m}. */
    static Shade of(MaterialTable t, int m) {
        float[] reflective = {t.reflective(m, 0), t.reflective(m, 1), t.reflective(m, 2)};
        return new Shade(new float[] {t.ambient(m, 0), t.ambient(m, 1), t.ambient(m, 2)},
                new float[] {t.diffuse(m, 0), t.diffuse(m, 1), t.diffuse(m, 2)},
                new float[] {t.specular(m, 0), t.specular(m, 1), t.specular(m, 2)},
                t.isMetallic(m) ? new float[] {t.metal(m, 0), t.metal(m, 1), t.metal(m, 2)} : null, reflective,
                t.isClear(m) ? t.clarity(m) : null, ClearSums.body(t.clarity(m)), t.isTextured(m),
                t.texture(m) != null,
                t.isSpecular(m),
                reflective[0] > 0 || reflective[1] > 0 || reflective[2] > 0);
    }
}
