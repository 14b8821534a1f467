package lightning.render.engine.lanes;

import static java.util.Objects.requireNonNull;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.shading.ClearChannel;
import lightning.render.shading.InteriorTint;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SumKernel;
import lightning.render.shading.SumOperands;
import lightning.render.shading.TermKernel;
import lightning.render.trace.HitRows;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/**
 * Lane version of {@link SumKernel}: processes rows in whole, aligned vectors. Kernels are short, because in longer ones
 * vectors would be boxed.
 */
final class SumLanes implements SumKernel {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;

    private final float[] metalSpecular = new float[TermKernel.MAX_ROWS];

    /** Sums one channel with tinted shadows. */
    private static void tintedSum(int from, int rows, SumOperands a, float[] weight, float[][] tint, float[][] sums, float[] to) {
        for (int i = from & -F.length(); i < rows; i += F.length()) {
            FloatVector sum = tintedSum(i, a, weight, tint, 0, a.firstChainLength)
                    .add(tintedSum(i, a, weight, tint, a.firstChainLength, a.lightCount));
            for (int s = 0; s < a.sumCount; s++) {
                sum = sum.add(FloatVector.fromArray(F, sums[s], i));
            }
            sum.intoArray(to, i);
        }
    }

    private static FloatVector tintedSum(int i, SumOperands a, float[] weight, float[][] tint, int from, int to) {
        FloatVector sum = FloatVector.zero(F);
        for (int l = from; l < to; l++) {
            sum = sum.add(FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i))
                    .mul(FloatVector.fromArray(F, tint[l], i)).mul(weight[l]));
        }
        return sum;
    }

    @Override
    public void sum(int from, int rows, SumOperands a, float[][] to) {
        if (a.tinted) {
            tintedSum(from, rows, a, a.red, a.tintRed, a.sumRed, to[0]);
            tintedSum(from, rows, a, a.green, a.tintGreen, a.sumGreen, to[1]);
            tintedSum(from, rows, a, a.blue, a.tintBlue, a.sumBlue, to[2]);
            return;
        }
        for (int i = from & -F.length(); i < rows; i += F.length()) {
            FloatVector r = FloatVector.zero(F);
            FloatVector g = r;
            FloatVector b = r;
            for (int l = 0; l < a.firstChainLength; l++) {
                FloatVector attenuated = FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i));
                r = r.add(attenuated.mul(a.red[l]));
                g = g.add(attenuated.mul(a.green[l]));
                b = b.add(attenuated.mul(a.blue[l]));
            }
            if (a.firstChainLength < a.lightCount) {
                FloatVector r2 = FloatVector.zero(F);
                FloatVector g2 = r2;
                FloatVector b2 = r2;
                for (int l = a.firstChainLength; l < a.lightCount; l++) {
                    FloatVector attenuated = FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i));
                    r2 = r2.add(attenuated.mul(a.red[l]));
                    g2 = g2.add(attenuated.mul(a.green[l]));
                    b2 = b2.add(attenuated.mul(a.blue[l]));
                }
                r = r.add(r2);
                g = g.add(g2);
                b = b.add(b2);
            }
            for (int s = 0; s < a.sumCount; s++) {
                r = r.add(FloatVector.fromArray(F, a.sumRed[s], i));
                g = g.add(FloatVector.fromArray(F, a.sumGreen[s], i));
                b = b.add(FloatVector.fromArray(F, a.sumBlue[s], i));
            }
            r.intoArray(to[0], i);
            g.intoArray(to[1], i);
            b.intoArray(to[2], i);
        }
    }

    @Override
    public void shade(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] diffuse, float @Nullable [][] specular,
            float @Nullable [][] grazing, float @Nullable [][] mirrored, float[][] to) {
        int start = rows.runStart(run) & -F.length();
        int end = rows.runEnd[run];
        for (int c = 0; c < 3; c++) {
            float[] texel = material.isTextured() ? rows.texel(c) : null;
            float[] image = material.isReflective() ? requireNonNull(mirrored)[c] : null;
            float[] highlights = specular == null ? null : specular[c];
            if (grazing != null) {
                assert highlights != null;
                writeMetalSpecular(start, end, material, c, highlights, grazing[c], texel);
                highlights = metalSpecular;
            }
            shadeChannel(start, end, material, c, emitted[c], diffuse[c], highlights,
                    grazing == null ? material.specular()[c] : 1, texel,
                    image, to[c]);
        }
    }

    /**
     * Writes F0 times the specular sum plus the grazing one, for one channel of a metallic material, to {@link #metalSpecular}.
     */
    private void writeMetalSpecular(int start, int end, ShadingMaterial material, int channel, float[] specular, float[] grazing,
            float @Nullable [] texel) {
        float metal = requireNonNull(material.texturedF0())[channel];
        float plain = material.specular()[channel];
        for (int i = start; i < end; i += F.length()) {
            FloatVector f0 = texel == null ? FloatVector.broadcast(F, metal) : FloatVector.fromArray(F, texel, i).mul(metal);
            FloatVector.fromArray(F, specular, i).mul(f0.add(plain)).add(FloatVector.fromArray(F, grazing, i)).intoArray(metalSpecular, i);
        }
    }

    /** Shades one channel. */
    private static void shadeChannel(int start, int end, ShadingMaterial material, int channel, float emitted, float[] diffuse,
            float @Nullable [] specular, float ks, float @Nullable [] texel, float @Nullable [] image, float[] to) {
        float kd = material.diffuse()[channel];
        float kr = material.reflective()[channel];
        for (int i = start; i < end; i += F.length()) {
            FloatVector light = FloatVector.fromArray(F, diffuse, i);
            // kd·texel first, as in {@code SurfacePoint.diffuse}.
            light = texel == null ? light.mul(kd) : light.mul(FloatVector.fromArray(F, texel, i).mul(kd));
            FloatVector color = light.add(emitted);
            if (image != null) {
                color = color.mul(1 - kr);
            }
            if (specular != null) {
                color = color.add(FloatVector.fromArray(F, specular, i).mul(ks));
            }
            if (image != null) {
                color = color.add(FloatVector.fromArray(F, image, i).mul(kr));
            }
            color.intoArray(to, i);
        }
    }

    @Override
    public void clearTerms(HitRows rows, int from, int to, Transmission clarity, InteriorTint interior, float[] share, float[][] tint) {
        ClearTermLanes.writeReflectances(rows, from, to, clarity, share);
        for (int c = 0; c < 3; c++) {
            ClearTermLanes.writeTransmittances(rows, from, to, interior, c, tint[c]);
        }
    }

    @Override
    public void clearSurface(int from, int to, ClearChannel k, float[] texel, float[] diffuse, float[] specular, float[] grazing,
            float[] share, float[] colors) {
        for (int i = from & -F.length(); i < to; i += F.length()) {
            FloatVector t = FloatVector.fromArray(F, texel, i);
            FloatVector left = FloatVector.broadcast(F, 1).sub(mirrorShare(share, i, k.reflective()));
            FloatVector body = FloatVector.fromArray(F, diffuse, i).mul(t.mul(k.diffuse())).add(k.emitted()).mul(left.mul(k.body()));
            FloatVector gloss = FloatVector.fromArray(F, specular, i).mul(t.mul(k.texturedF0()).add(k.specular()))
                    .add(FloatVector.fromArray(F, grazing, i));
            body.add(gloss).intoArray(colors, i);
        }
    }

    @Override
    public void clearColor(int from, int to, ClearChannel k, boolean hasSurface, float[] mirrored, float[] refracted, float[] share,
            float[] tint, float[] colors) {
        for (int i = from & -F.length(); i < to; i += F.length()) {
            FloatVector mirror = mirrorShare(share, i, k.reflective());
            FloatVector color = FloatVector.fromArray(F, mirrored, i).mul(mirror);
            if (hasSurface) {
                color = color.add(FloatVector.fromArray(F, colors, i));
            }
            color.add(FloatVector.broadcast(F, 1).sub(mirror).mul(k.clear()).mul(FloatVector.fromArray(F, refracted, i)))
                    .mul(FloatVector.fromArray(F, tint, i)).intoArray(colors, i);
        }
    }

    /** Returns the share of mirrored light of clear surfaces from their Fresnel reflectance. */
    private static FloatVector mirrorShare(float[] share, int i, float kr) {
        return FloatVector.fromArray(F, share, i).mul(1 - kr).add(kr);
    }
}
