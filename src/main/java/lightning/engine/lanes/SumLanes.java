package lightning.engine.lanes;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.shading.Luminaire;
import lightning.shading.Sums;

/** {@link Sums} in lanes. Plain loops with three stores were not vectorised and took eight times as long. */
final class SumLanes implements Sums {
    private static final VectorSpecies<Float> F = FloatVector.SPECIES_PREFERRED;

    @Override
    public void set(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = light.red();
        float g = light.green();
        float b = light.blue();
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector faded = FloatVector.fromArray(F, term, i).mul(FloatVector.fromArray(F, falloff, i));
            faded.mul(r).intoArray(red, i);
            faded.mul(g).intoArray(green, i);
            faded.mul(b).intoArray(blue, i);
        }
    }

    @Override
    public void add(int rows, Luminaire light, float[] term, float[] falloff, float[] red, float[] green, float[] blue) {
        float r = light.red();
        float g = light.green();
        float b = light.blue();
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector faded = FloatVector.fromArray(F, term, i).mul(FloatVector.fromArray(F, falloff, i));
            FloatVector.fromArray(F, red, i).add(faded.mul(r)).intoArray(red, i);
            FloatVector.fromArray(F, green, i).add(faded.mul(g)).intoArray(green, i);
            FloatVector.fromArray(F, blue, i).add(faded.mul(b)).intoArray(blue, i);
        }
    }

    @Override
    public void add(int rows, float[] from, float[] to) {
        for (int i = 0; i < rows; i += F.length()) {
            FloatVector.fromArray(F, to, i).add(FloatVector.fromArray(F, from, i)).intoArray(to, i);
        }
    }

    @Override
    public void close(int from, int to, Channel c, float[] out) {
        float[] texture = c.texture();
        float emitted = c.emitted();
        float kd = c.kd();
        float ks = c.ks();
        float kr = c.kr();
        for (int i = from; i < to; i += F.length()) {
            VectorMask<Float> in = F.indexInRange(i, to);
            FloatVector light = FloatVector.fromArray(F, c.diffuse(), i, in);
            // kd·texel first, as where a point carries its diffuse colour.
            light = texture == null ? light.mul(kd) : light.mul(FloatVector.fromArray(F, texture, i, in).mul(kd));
            FloatVector color = light.add(emitted);
            if (kr != 0) {
                color = color.mul(1 - kr);
            }
            if (ks != 0) {
                color = color.add(FloatVector.fromArray(F, c.specular(), i, in).mul(ks));
            }
            if (kr != 0) {
                color = color.add(FloatVector.fromArray(F, c.mirrored(), i, in).mul(kr));
            }
            color.intoArray(out, i, in);
        }
    }
}
