package lightning.render.engine.lanes;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.shading.Addends;
import lightning.render.shading.Shade;
import lightning.render.shading.Sums;
import lightning.render.shading.Terms;
import lightning.render.trace.HitRows;

/**
 * {@link Sums} in lanes: rows are gone over in whole, aligned lanes. Kernels are short, because in longer ones vectors become
 * objects.
 */
final class SumLanes implements Sums {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;

    private final float[] glow = new float[Terms.ROWS];

    /** One channel, where light passed clear shapes. */
    private static void tinted(int rows, Addends a, float[] weight, float[][] tint, float[][] sums, float[] to) {
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector sum = tinted(i, a, weight, tint, 0, a.first).add(tinted(i, a, weight, tint, a.first, a.lights));
            for (int s = 0; s < a.sums; s++) {
                sum = sum.add(FloatVector.fromArray(F, sums[s], i));
            }
            sum.intoArray(to, i);
        }
    }

    private static FloatVector tinted(int i, Addends a, float[] weight, float[][] tint, int from, int to) {
        FloatVector sum = FloatVector.zero(F);
        for (int l = from; l < to; l++) {
            sum = sum.add(FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i))
                    .mul(FloatVector.fromArray(F, tint[l], i)).mul(weight[l]));
        }
        return sum;
    }

    @Override
    public void sum(int rows, Addends a, float[][] to) {
        if (a.tinted) {
            tinted(rows, a, a.red, a.tintRed, a.sumRed, to[0]);
            tinted(rows, a, a.green, a.tintGreen, a.sumGreen, to[1]);
            tinted(rows, a, a.blue, a.tintBlue, a.sumBlue, to[2]);
            return;
        }
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector r = FloatVector.zero(F);
            FloatVector g = r;
            FloatVector b = r;
            for (int l = 0; l < a.first; l++) {
                FloatVector faded = FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i));
                r = r.add(faded.mul(a.red[l]));
                g = g.add(faded.mul(a.green[l]));
                b = b.add(faded.mul(a.blue[l]));
            }
            if (a.first < a.lights) {
                FloatVector r2 = FloatVector.zero(F);
                FloatVector g2 = r2;
                FloatVector b2 = r2;
                for (int l = a.first; l < a.lights; l++) {
                    FloatVector faded = FloatVector.fromArray(F, a.term[l], i).mul(FloatVector.fromArray(F, a.falloff[l], i));
                    r2 = r2.add(faded.mul(a.red[l]));
                    g2 = g2.add(faded.mul(a.green[l]));
                    b2 = b2.add(faded.mul(a.blue[l]));
                }
                r = r.add(r2);
                g = g.add(g2);
                b = b.add(b2);
            }
            for (int s = 0; s < a.sums; s++) {
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
    public void close(HitRows rows, int run, Shade shade, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            float[][] mirrored, float[][] to) {
        int start = rows.runStart(run) & -F.length();
        int end = rows.runEnd[run];
        for (int c = 0; c < 3; c++) {
            float[] texel = shade.textured() ? rows.texel(c) : null;
            float[] image = shade.mirrors() ? mirrored[c] : null;
            float[] shown = specular == null ? null : specular[c];
            if (grazing != null) {
                glow(start, end, shade, c, shown, grazing[c], texel);
                shown = glow;
            }
            close(start, end, shade, c, shade.ambient()[c] * ambience, diffuse[c], shown, grazing == null ? shade.specular()[c] : 1, texel,
                    image, to[c]);
        }
    }

    /** Writes F0 times the specular sum plus the grazing one, of one channel of a metallic material, to {@link #glow}. */
    private void glow(int start, int end, Shade shade, int channel, float[] specular, float[] grazing, float[] texel) {
        float metal = shade.metal()[channel];
        float plain = shade.specular()[channel];
        for (int i = start; i < end; i += F.length()) {
            FloatVector f0 = texel == null ? FloatVector.broadcast(F, metal) : FloatVector.fromArray(F, texel, i).mul(metal);
            FloatVector.fromArray(F, specular, i).mul(f0.add(plain)).add(FloatVector.fromArray(F, grazing, i)).intoArray(glow, i);
        }
    }

    /** One channel. */
    private static void close(int start, int end, Shade shade, int channel, float emitted, float[] diffuse, float[] specular, float ks,
            float[] texel, float[] image, float[] to) {
        float kd = shade.diffuse()[channel];
        float kr = shade.reflective()[channel];
        for (int i = start; i < end; i += F.length()) {
            FloatVector light = FloatVector.fromArray(F, diffuse, i);
            // kd·texel first, as where a point carries its diffuse colour.
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
}
