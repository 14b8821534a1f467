package lightning.render.engine.scalar;

import java.util.Arrays;
import lightning.render.gather.ray.FilmLight;
import lightning.render.shading.InteriorTint;
import lightning.render.shading.SumKernel;
import lightning.render.shading.SumOperands;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import lightning.scene.material.Transmission;

/** Scalar implementation of {@link SumKernel}. */
final class ScalarSums implements SumKernel {
    @Override
    public void weightedSum(FilmLight light, int[] number, float[] weight, int count, float[] to) {
        float[] values = light.values();
        int width = light.stride();
        Arrays.fill(to, 0, width, 0);
        for (int n = 0; n < count; n++) {
            int at = width * number[n];
            for (int k = 0; k < width; k++) {
                to[k] += weight[n] * values[at + k];
            }
        }
    }

    @Override
    public void sum(int from, int to, SumOperands addends, float[][] sums) {
        sum(from, to, addends, addends.red, addends.tintRed, addends.sumRed, sums[0]);
        sum(from, to, addends, addends.green, addends.tintGreen, addends.sumGreen, sums[1]);
        sum(from, to, addends, addends.blue, addends.tintBlue, addends.sumBlue, sums[2]);
    }

    /** Sums one channel. */
    private static void sum(int from, int to, SumOperands addends, float[] weight, float[][] tint, float[][] known, float[] sums) {
        for (int i = from; i < to; i++) {
            float sum = addends.tinted
                    ? weightedSum(i, addends, weight, tint, 0, addends.firstChainLength)
                            + weightedSum(i, addends, weight, tint, addends.firstChainLength, addends.lightCount)
                    : weightedSum(i, addends, weight, 0, addends.firstChainLength)
                            + weightedSum(i, addends, weight, addends.firstChainLength, addends.lightCount);
            for (int s = 0; s < addends.sumCount; s++) {
                sum += known[s][i];
            }
            sums[i] = sum;
        }
    }

    private static float weightedSum(int i, SumOperands addends, float[] weight, float[][] tint, int from, int to) {
        float sum = 0;
        for (int l = from; l < to; l++) {
            sum += addends.term[l][i] * addends.falloff[l][i] * tint[l][i] * weight[l];
        }
        return sum;
    }

    private static float weightedSum(int i, SumOperands addends, float[] weight, int from, int to) {
        float sum = 0;
        for (int l = from; l < to; l++) {
            sum += addends.term[l][i] * addends.falloff[l][i] * weight[l];
        }
        return sum;
    }

    @Override
    public void clearTerms(HitRows rows, int from, int to, Transmission clarity, InteriorTint interior, float[] share, float[][] tint) {
        for (int i = from; i < to; i++) {
            share[i] = Refraction.fresnelReflectance(clarity, rows.isInside(i), rows.nx[i], rows.ny[i], rows.nz[i], rows.vx[i], rows.vy[i],
                    rows.vz[i]);
        }
        assert rows.insideDistance != null;
        for (int c = 0; c < 3; c++) {
            for (int i = from; i < to; i++) {
                tint[c][i] = interior.transmittance(c, rows.insideDistance[i]);
            }
        }
    }
}
