package lightning.render.engine.lanes;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.gather.ray.FilmLight;
import lightning.render.shading.InteriorTint;
import lightning.render.shading.SumKernel;
import lightning.render.shading.SumOperands;
import lightning.render.trace.HitRows;
import lightning.scene.material.Transmission;

/**
 * Lane version of {@link SumKernel}: processes rows in whole, aligned vectors. Kernels are short, because in longer ones
 * vectors would be boxed.
 */
final class SumLanes implements SumKernel {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;
    /** Red, green and blue of one film, and an unused value. */
    private static final VectorSpecies<Float> QUAD = FloatVector.SPECIES_128;

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
    public void weightedSum(FilmLight light, int[] number, float[] weight, int count, float[] to) {
        int width = light.stride();
        if (width < F.length()) {
            for (int k = 0; k < width; k += QUAD.length()) {
                weightedQuad(light.values(), number, weight, count, width, k, to);
            }
        } else {
            for (int k = 0; k < width; k += F.length()) {
                weightedVector(light.values(), number, weight, count, width, k, to);
            }
        }
    }

    private static void weightedVector(float[] values, int[] number, float[] weight, int count, int width, int k, float[] to) {
        FloatVector sum = FloatVector.zero(F);
        for (int n = 0; n < count; n++) {
            sum = sum.add(FloatVector.fromArray(F, values, width * number[n] + k).mul(weight[n]));
        }
        sum.intoArray(to, k);
    }

    private static void weightedQuad(float[] values, int[] number, float[] weight, int count, int width, int k, float[] to) {
        FloatVector sum = FloatVector.zero(QUAD);
        for (int n = 0; n < count; n++) {
            sum = sum.add(FloatVector.fromArray(QUAD, values, width * number[n] + k).mul(weight[n]));
        }
        sum.intoArray(to, k);
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
    public void clearTerms(HitRows rows, int from, int to, Transmission clarity, InteriorTint interior, float[] share, float[][] tint) {
        ClearTermLanes.writeReflectances(rows, from, to, clarity, share);
        for (int c = 0; c < 3; c++) {
            ClearTermLanes.writeTransmittances(rows, from, to, interior, c, tint[c]);
        }
    }
}
