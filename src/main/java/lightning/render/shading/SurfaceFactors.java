package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.base.math.Rgb;
import lightning.render.trace.Refraction;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;
import lightning.scene.material.Transmission;

/**
 * Factors by which a point of a surface sends each kind of light on, red, green and blue each: the color is linear in them.
 *
 * <pre>
 * I = D·Idiff + (S·Ispec + G·Igraz) + M·Cr + R·Ct + (L·first + Q·second) + E·emitted
 * </pre>
 *
 * <table>
 * <caption>Factors of the {@link LightingEquation}</caption>
 * <tr><th></th><th>opaque</th><th>clear, with m, b and T</th><th>principled ({@link PrincipledWeights})</th></tr>
 * <tr><td>D</td><td>kd·(1 − kr)</td><td>kd·((1 − m)·b)·T</td><td>kd·d</td></tr>
 * <tr><td>S</td><td>ks</td><td>ks·T</td><td>factor of Ispec</td></tr>
 * <tr><td>G</td><td>1</td><td>T</td><td>factor of Igraz</td></tr>
 * <tr><td>M</td><td>kr</td><td>m·T</td><td>of mirrored rays</td></tr>
 * <tr><td>R</td><td>0</td><td>(1 − m)·kt·T</td><td>0</td></tr>
 * <tr><td>L, Q</td><td>0</td><td>0</td><td>of blurred reflections</td></tr>
 * <tr><td>E</td><td>1 − kr</td><td>((1 − m)·b)·T</td><td>1</td></tr>
 * </table>
 */
public final class SurfaceFactors {
    private final float[] diffuse = new float[3];
    private final float[] specular = new float[3];
    private final float[] grazing = {1, 1, 1};
    private final float[] mirrored = new float[3];
    private final float[] refracted = new float[3];
    private final float[] first = new float[3];
    private final float[] second = new float[3];
    private final float[] emitted = new float[3];
    private final float[] interior = {1, 1, 1};
    private float fresnel;

    /** @param material material of the point */
    public SurfaceFactors(SurfacePoint hit, Material material) {
        switch (Bsdf.of(material)) {
            case Bsdf.Phong _,Bsdf.Metal _ -> setOpaque(hit, material.reflective());
            case Bsdf.Principled principled -> setPrincipled(hit, principled);
            case Bsdf.Clear clear -> setClear(hit, clear, material.reflective());
        }
    }

    private void setOpaque(SurfacePoint hit, Rgb reflective) {
        for (int c = 0; c < 3; c++) {
            float kr = LightWeight.channel(reflective, c);
            diffuse[c] = hit.diffuse()[c] * (1 - kr);
            specular[c] = hit.specular()[c];
            mirrored[c] = kr;
            emitted[c] = 1 - kr;
        }
    }

    private void setClear(SurfacePoint hit, Bsdf.Clear clear, Rgb reflective) {
        Transmission transmission = clear.transmission();
        fresnel = hit.reflectance();
        clear.interior().write(requireNonNull(hit.clearSide()).insideDistance(), interior);
        for (int c = 0; c < 3; c++) {
            float mirror = Refraction.mirrorShare(LightWeight.channel(reflective, c), fresnel);
            float left = (1 - mirror) * clear.body();
            diffuse[c] = hit.diffuse()[c] * left * interior[c];
            specular[c] = hit.specular()[c] * interior[c];
            grazing[c] = interior[c];
            mirrored[c] = mirror * interior[c];
            refracted[c] = (1 - mirror) * LightWeight.channel(transmission.color(), c) * interior[c];
            emitted[c] = left * interior[c];
        }
    }

    private void setPrincipled(SurfacePoint hit, Bsdf.Principled material) {
        var weights = new PrincipledWeights();
        weights.moveTo(material, hit);
        for (int c = 0; c < 3; c++) {
            float shine = weights.shine(material, hit.specular()[c],
                    material.colors().square(c, hit.mapped(material.material()), hit.texel()[c]));
            float graze = weights.graze(material, c);
            diffuse[c] = weights.diffuse(hit.diffuse()[c]);
            specular[c] = shine;
            grazing[c] = graze;
            mirrored[c] = weights.mirror(material, shine, graze);
            first[c] = weights.first(material, shine, graze);
            second[c] = weights.second(material, c, graze);
            emitted[c] = 1;
        }
    }

    /** Returns the body share of a clear surface: 1 minus its largest transmission channel. */
    public static float bodyShare(Transmission clarity) {
        return 1 - (float) clarity.color().max();
    }

    /**
     * Returns what a channel shows of diffuse, specular and grazing light.
     *
     * @param light lights' diffuse sum with gathered light, then their specular and grazing sums
     */
    public float lit(int c, float light, float shine, float graze) {
        return diffuse[c] * light + (specular[c] * shine + grazing[c] * graze);
    }

    /** Returns what a channel shows of the mirrored ray. */
    public float mirrored(int c, float color) {
        return mirrored[c] * color;
    }

    /** Returns what a channel shows of the refracted ray. */
    public float refracted(int c, float color) {
        return refracted[c] * color;
    }

    /** Returns what a channel shows of the two means of light that blurred reflections gather. */
    public float reflected(int c, float one, float other) {
        return first[c] * one + second[c] * other;
    }

    /** Returns what a channel shows of light that the surface emits. */
    public float emitted(int c, float amount) {
        return emitted[c] * amount;
    }

    /** Returns the Fresnel share that a clear surface mirrors; 0 for other surfaces. */
    public float fresnel() {
        return fresnel;
    }

    /** Returns the transmittance of a channel along the path inside a clear solid; 1 if there was no such path. */
    public float interiorTint(int c) {
        return interior[c];
    }
}
