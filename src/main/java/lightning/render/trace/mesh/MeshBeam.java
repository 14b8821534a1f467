package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.Rays;

/**
 * All that the rays of a packet sweep, to be tested against the eight boxes of a node at once.
 *
 * <p>At the distance t each ray is within a box that moves: from {@code low + t·lowStep} to {@code high + t·highStep}. It touches a
 * node's box while low + t·lowStep is no more than the box's greater side and high + t·highStep no less than its lesser one: on each axis
 * two inequalities of t (as {@code trace.Beam} does for whole tiles). Origins are made wider by twice what the rays are, which covers this
 * reckoning's rounding as well, and steps by 2⁻²², more than floats round them.
 */
final class MeshBeam {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Float> LANES = FloatVector.SPECIES_PREFERRED;
    private static final float WIDER = 0x1p-22f;
    /** No distance within a mesh is as large. */
    private static final float NEVER = 1e30f;

    /** For each axis, factor and summand of: in by the greater side, out by it, in by the lesser side, out by it. */
    private final float[] c = new float[24];
    private final float[] least = new float[Rays.WIDTH];
    private final float[] most = new float[Rays.WIDTH];
    private final float[] leastStep = new float[Rays.WIDTH];
    private final float[] mostStep = new float[Rays.WIDTH];
    /** Where the beam enters each child, as the bits of floats. */
    final int[] in = new int[MeshTree.WIDTH];
    /** The rays that were taken, one bit for each. */
    long rays;
    /** The greatest difference between the rays' steps on any axis. */
    float spread;
    /** The greatest difference between the rays' origins on any axis. */
    float width;

    /** Takes a set of rays, not empty, of the packets {@code i … end − 1}. */
    void take(MeshSight sight, long set, int i, int end) {
        rays = set;
        spread = 0;
        width = 0;
        axis(sight.startX, sight.stepX, sight.wide, i, end, 0);
        axis(sight.startY, sight.stepY, sight.wide, i, end, 8);
        axis(sight.startZ, sight.stepZ, sight.wide, i, end, 16);
    }

    private void axis(float[] start, float[] step, float[] wide, int from, int end, int at) {
        FloatVector low = FloatVector.broadcast(LANES, Float.POSITIVE_INFINITY);
        FloatVector high = low.neg();
        FloatVector lowStep = low;
        FloatVector highStep = high;
        for (int i = from; i < end; i += Rays.WIDTH) {
            VectorMask<Float> open = VectorMask.fromLong(LANES, rays >>> i);
            FloatVector o = FloatVector.fromArray(LANES, start, i);
            FloatVector w = FloatVector.fromArray(LANES, wide, i);
            FloatVector d = FloatVector.fromArray(LANES, step, i);
            w = w.add(w);
            FloatVector less = o.sub(w);
            FloatVector more = o.add(w);
            low = low.blend(less, less.compare(LT, low).and(open));
            high = high.blend(more, more.compare(GT, high).and(open));
            lowStep = lowStep.blend(d, d.compare(LT, lowStep).and(open));
            highStep = highStep.blend(d, d.compare(GT, highStep).and(open));
        }
        low.intoArray(least, 0);
        high.intoArray(most, 0);
        lowStep.intoArray(leastStep, 0);
        highStep.intoArray(mostStep, 0);
        fold(at);
    }

    private void fold(int at) {
        float low = least[0];
        float high = most[0];
        float lowStep = leastStep[0];
        float highStep = mostStep[0];
        for (int i = 1; i < Rays.WIDTH; i++) {
            low = least[i] < low ? least[i] : low;
            high = most[i] > high ? most[i] : high;
            lowStep = leastStep[i] < lowStep ? leastStep[i] : lowStep;
            highStep = mostStep[i] > highStep ? mostStep[i] : highStep;
        }
        width = high - low > width ? high - low : width;
        spread = highStep - lowStep > spread ? highStep - lowStep : spread;
        lowStep -= WIDER;
        highStep += WIDER;
        lowStep = lowStep == 0 ? -WIDER : lowStep;
        highStep = highStep == 0 ? WIDER : highStep;
        // low + t·lowStep ≤ the greater side: until then where the step is forwards, from then on where it is backwards.
        float a = 1 / lowStep;
        put(at, lowStep < 0, a, -low * a);
        float b = 1 / highStep;
        put(at + 4, highStep > 0, b, -high * b);
    }

    private void put(int at, boolean from, float factor, float summand) {
        c[at] = from ? factor : 0;
        c[at + 1] = from ? summand : 0;
        c[at + 2] = from ? 0 : factor;
        c[at + 3] = from ? NEVER : summand;
    }

    /** The children of a node that the beam touches up to a distance, as one bit each; writes {@link #in}. */
    int touches(MeshTree tree, int node, int far) {
        float[] b = tree.box;
        float[] k = c;
        int at = MeshTree.NODE * node;
        FloatVector lesser = FloatVector.fromArray(FLOATS, b, at);
        FloatVector greater = FloatVector.fromArray(FLOATS, b, at + 8);
        IntVector enters = greater.fma(FloatVector.broadcast(FLOATS, k[0]), FloatVector.broadcast(FLOATS, k[1])).reinterpretAsInts()
                .max(lesser.fma(FloatVector.broadcast(FLOATS, k[4]), FloatVector.broadcast(FLOATS, k[5])).reinterpretAsInts()).max(0);
        IntVector leaves = greater.fma(FloatVector.broadcast(FLOATS, k[2]), FloatVector.broadcast(FLOATS, k[3])).reinterpretAsInts()
                .min(lesser.fma(FloatVector.broadcast(FLOATS, k[6]), FloatVector.broadcast(FLOATS, k[7])).reinterpretAsInts()).min(far);
        lesser = FloatVector.fromArray(FLOATS, b, at + 16);
        greater = FloatVector.fromArray(FLOATS, b, at + 24);
        enters = enters.max(greater.fma(FloatVector.broadcast(FLOATS, k[8]), FloatVector.broadcast(FLOATS, k[9])).reinterpretAsInts())
                .max(lesser.fma(FloatVector.broadcast(FLOATS, k[12]), FloatVector.broadcast(FLOATS, k[13])).reinterpretAsInts());
        leaves = leaves.min(greater.fma(FloatVector.broadcast(FLOATS, k[10]), FloatVector.broadcast(FLOATS, k[11])).reinterpretAsInts())
                .min(lesser.fma(FloatVector.broadcast(FLOATS, k[14]), FloatVector.broadcast(FLOATS, k[15])).reinterpretAsInts());
        lesser = FloatVector.fromArray(FLOATS, b, at + 32);
        greater = FloatVector.fromArray(FLOATS, b, at + 40);
        enters = enters.max(greater.fma(FloatVector.broadcast(FLOATS, k[16]), FloatVector.broadcast(FLOATS, k[17])).reinterpretAsInts())
                .max(lesser.fma(FloatVector.broadcast(FLOATS, k[20]), FloatVector.broadcast(FLOATS, k[21])).reinterpretAsInts());
        leaves = leaves.min(greater.fma(FloatVector.broadcast(FLOATS, k[18]), FloatVector.broadcast(FLOATS, k[19])).reinterpretAsInts())
                .min(lesser.fma(FloatVector.broadcast(FLOATS, k[22]), FloatVector.broadcast(FLOATS, k[23])).reinterpretAsInts());
        enters.intoArray(in, 0);
        return (int) enters.compare(LE, leaves).toLong();
    }
}
