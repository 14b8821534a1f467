package lightning.engine.scalar;

import lightning.shading.Luminaire;
import lightning.shading.Sums;

/** {@link Sums} in plain loops. */
final class ScalarSums implements Sums {
    @Override
    public void set(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = light.red();
        float g = light.green();
        float b = light.blue();
        for (int i = 0; i < rows; i++) {
            float faded = term[i] * falloff[i];
            red[i] = faded * r;
            green[i] = faded * g;
            blue[i] = faded * b;
        }
    }

    @Override
    public void add(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = light.red();
        float g = light.green();
        float b = light.blue();
        for (int i = 0; i < rows; i++) {
            float faded = term[i] * falloff[i];
            red[i] += faded * r;
            green[i] += faded * g;
            blue[i] += faded * b;
        }
    }

    @Override
    public void add(int rows, float[] from, float[] to) {
        for (int i = 0; i < rows; i++) {
            to[i] += from[i];
        }
    }

    @Override
    public void close(int from, int to, Channel c, float[] out) {
        for (int i = from; i < to; i++) {
            float kd = c.texture() == null ? c.kd() : c.texture()[i] * c.kd();
            float color = c.diffuse()[i] * kd + c.emitted();
            if (c.kr() != 0) {
                color *= 1 - c.kr();
            }
            if (c.ks() != 0) {
                color += c.specular()[i] * c.ks();
            }
            if (c.kr() != 0) {
                color += c.mirrored()[i] * c.kr();
            }
            out[i] = color;
        }
    }
}
