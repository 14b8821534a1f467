package lightning.render.engine.scalar;

import lightning.render.shading.Addends;
import lightning.render.shading.Shade;
import lightning.render.shading.Sums;
import lightning.render.trace.HitRows;

/** {@link Sums} in plain loops. */
final class ScalarSums implements Sums {
    @Override
    public void sum(int rows, Addends addends, float[][] to) {
        sum(rows, addends, addends.red, addends.tintRed, addends.sumRed, to[0]);
        sum(rows, addends, addends.green, addends.tintGreen, addends.sumGreen, to[1]);
        sum(rows, addends, addends.blue, addends.tintBlue, addends.sumBlue, to[2]);
    }

    /** One channel. */
    private static void sum(int rows, Addends addends, float[] weight, float[][] tint, float[][] sums, float[] to) {
        for (int i = 0; i < rows; i++) {
            float sum = addends.tinted
                    ? chain(i, addends, weight, tint, 0, addends.first) + chain(i, addends, weight, tint, addends.first, addends.lights)
                    : chain(i, addends, weight, 0, addends.first) + chain(i, addends, weight, addends.first, addends.lights);
            for (int s = 0; s < addends.sums; s++) {
                sum += sums[s][i];
            }
            to[i] = sum;
        }
    }

    private static float chain(int i, Addends addends, float[] weight, float[][] tint, int from, int to) {
        float sum = 0;
        for (int l = from; l < to; l++) {
            sum += addends.term[l][i] * addends.falloff[l][i] * tint[l][i] * weight[l];
        }
        return sum;
    }

    private static float chain(int i, Addends addends, float[] weight, int from, int to) {
        float sum = 0;
        for (int l = from; l < to; l++) {
            sum += addends.term[l][i] * addends.falloff[l][i] * weight[l];
        }
        return sum;
    }

    @Override
    public void close(HitRows rows, int run, Shade shade, float ambience, float[][] diffuse, float[][] specular, float[][] grazing,
            float[][] mirrored, float[][] to) {
        for (int c = 0; c < 3; c++) {
            float emitted = shade.ambient()[c] * ambience;
            float kd = shade.diffuse()[c];
            float kr = shade.reflective()[c];
            float[] texel = rows.texel(c);
            for (int i = rows.runStart(run); i < rows.runEnd[run]; i++) {
                float color = diffuse[c][i] * (shade.textured() ? texel[i] * kd : kd) + emitted;
                if (shade.mirrors()) {
                    color *= 1 - kr;
                }
                if (grazing != null) {
                    float metal = shade.textured() ? texel[i] * shade.metal()[c] : shade.metal()[c];
                    color += specular[c][i] * (metal + shade.specular()[c]) + grazing[c][i];
                } else if (specular != null) {
                    color += specular[c][i] * shade.specular()[c];
                }
                if (shade.mirrors()) {
                    color += mirrored[c][i] * kr;
                }
                to[c][i] = color;
            }
        }
    }
}
