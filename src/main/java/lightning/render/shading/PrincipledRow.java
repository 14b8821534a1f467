package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows;

/** Colors of a row of an opaque principled material, with its texture and its metalness map. One instance per thread. */
public final class PrincipledRow {
    private final float[] diffuse = new float[3];
    private final float[] f0 = new float[3];

    /** Moves to a row of a material. */
    public void moveTo(ShadingMaterial material, HitRows rows, int row) {
        PrincipledMaterial principled = requireNonNull(material.principled());
        float[] metalF0 = requireNonNull(material.texturedF0());
        double metalness = principled.mixed() == null ? 0 : principled.mappedMetalness(rows, row);
        for (int c = 0; c < 3; c++) {
            float texel = material.isTextured() ? requireNonNull(rows.texel(c))[row] : 1;
            if (principled.mixed() == null) {
                diffuse[c] = material.diffuse()[c] * texel;
                f0[c] = metalF0[c] * texel + material.specular()[c];
            } else {
                diffuse[c] = principled.mixed().diffuse(c, metalness) * texel;
                f0[c] = principled.mixed().metalF0(c, metalness) * texel + principled.mixed().specular(c, metalness);
            }
        }
    }

    /** Returns one channel of k<sub>diffuse</sub>. */
    public float diffuse(int channel) {
        return diffuse[channel];
    }

    /** Returns one channel of F0. */
    public float f0(int channel) {
        return f0[channel];
    }
}
