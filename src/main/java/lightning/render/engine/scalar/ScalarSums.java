package lightning.render.engine.scalar;

import static java.util.Objects.requireNonNull;

import lightning.render.shading.ClearChannel;
import lightning.render.shading.InteriorTint;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.ShadingMaterial;
import lightning.render.shading.SumKernel;
import lightning.render.shading.SumOperands;
import lightning.render.trace.HitRows;
import lightning.render.trace.Refraction;
import lightning.scene.material.Transmission;
import org.jspecify.annotations.Nullable;

/** Scalar implementation of {@link SumKernel}. */
final class ScalarSums implements SumKernel {
    private static final float[] NO_TEXELS = {};

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
    public void shade(HitRows rows, int run, ShadingMaterial material, float[] emitted, float[][] diffuse, float @Nullable [][] specular,
            float @Nullable [][] grazing, float @Nullable [][] mirrored, float[][] to) {
        for (int c = 0; c < 3; c++) {
            float own = emitted[c];
            float kd = material.diffuse()[c];
            float kr = material.reflective()[c];
            float[] texel = material.isTextured() ? requireNonNull(rows.texel(c)) : NO_TEXELS;
            float[] f0 = material.texturedF0();
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                float color = diffuse[c][i] * (material.isTextured() ? texel[i] * kd : kd) + own;
                if (material.isReflective()) {
                    color *= 1 - kr;
                }
                if (grazing != null) {
                    assert f0 != null && specular != null;
                    float metal = material.isTextured() ? texel[i] * f0[c] : f0[c];
                    color += specular[c][i] * (metal + material.specular()[c]) + grazing[c][i];
                } else if (specular != null) {
                    color += specular[c][i] * material.specular()[c];
                }
                if (material.isReflective()) {
                    assert mirrored != null;
                    color += mirrored[c][i] * kr;
                }
                to[c][i] = color;
            }
        }
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

    @Override
    public void clearSurface(int from, int to, ClearChannel channel, float[] texel, float[] diffuse, float[] specular, float[] grazing,
            float[] share, float[] colors) {
        for (int i = from; i < to; i++) {
            colors[i] = LightingEquation.clearSurface(channel.emitted(), channel.diffuse() * texel[i], diffuse[i],
                    channel.texturedF0() * texel[i] + channel.specular(), specular[i], grazing[i], channel.reflective(), channel.body(),
                    share[i]);
        }
    }

    @Override
    public void clearColor(int from, int to, ClearChannel channel, boolean hasSurface, float[] mirrored, float[] refracted, float[] share,
            float[] tint, float[] colors) {
        for (int i = from; i < to; i++) {
            colors[i] = LightingEquation.clearColor(hasSurface ? colors[i] : 0, channel.reflective(), mirrored[i], share[i],
                    channel.clear(), refracted[i], tint[i]);
        }
    }
}
