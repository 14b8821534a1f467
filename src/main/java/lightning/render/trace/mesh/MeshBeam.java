package lightning.render.trace.mesh;

import static jdk.incubator.vector.VectorOperators.ASHR;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.MAX;
import static jdk.incubator.vector.VectorOperators.MIN;
import static jdk.incubator.vector.VectorOperators.XOR;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.LaneRays;

/**
 * Beam of a packet's rays, tested against all eight boxes of a node in one operation.
 *
 * <p>At distance t each ray is within a moving box: from {@code low + t·lowStep} to {@code high + t·highStep}. It touches a
 * node's box while low + t·lowStep ≤ the box's maximum and high + t·highStep ≥ its minimum: two inequalities in t per axis (as
 * in {@code RayBeam} for whole tiles). Origins are padded by twice the width of the rays, which also covers rounding here, and
 * steps by 2⁻²², more than their rounding to float.
 */
final class MeshBeam {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Float> LANES = FloatVector.SPECIES_PREFERRED;
    private static final float STEP_PADDING = 0x1p-22f;
    /** Greater than any distance within a mesh. */
    private static final float UNREACHED = 1e30f;

    /** Factor and summand per axis for: entry by the maximum, exit by it, entry by the minimum, exit by it. */
    private final float[] coefficients = new float[24];
    /** Entry distance of the beam into each child, as float bits. */
    final int[] entryBits = new int[MeshTree.WIDTH];
    /** Rays of the beam, one bit each. */
    long rays;
    /** Center of the rays' steps on each axis, and the largest difference from it. */
    final float[] stepCenter = new float[3];
    final float[] stepExtent = new float[3];
    /** Maximum difference between the rays' steps on any axis. */
    float stepSpread;
    /** Maximum difference between the rays' origins on any axis. */
    float originSpread;

    /** Sets a non-empty set of rays of the packets {@code i … end − 1}. */
    void setRays(MeshFloatLines lines, long rayMask, int i, int end) {
        rays = rayMask;
        stepSpread = 0;
        originSpread = 0;
        if (lines.hasSharedStart) {
            float width = 2 * lines.sharedWidth;
            boundAxis(lines.sharedX - width, lines.sharedX + width, lines.stepX, i, end, 0);
            boundAxis(lines.sharedY - width, lines.sharedY + width, lines.stepY, i, end, 8);
            boundAxis(lines.sharedZ - width, lines.sharedZ + width, lines.stepZ, i, end, 16);
            return;
        }
        boundAxis(lines.startX, lines.stepX, lines.lineWidth, i, end, 0);
        boundAxis(lines.startY, lines.stepY, lines.lineWidth, i, end, 8);
        boundAxis(lines.startZ, lines.stepZ, lines.lineWidth, i, end, 16);
    }

    /** Bounds lines that all start at one point, from {@code low} to {@code high} with their width. */
    private void boundAxis(float low, float high, float[] step, int from, int end, int at) {
        FloatVector lowStep = FloatVector.broadcast(LANES, Float.POSITIVE_INFINITY);
        FloatVector highStep = lowStep.neg();
        for (int i = from; i < end; i += LaneRays.WIDTH) {
            VectorMask<Float> active = VectorMask.fromLong(LANES, rays >>> i);
            FloatVector d = FloatVector.fromArray(LANES, step, i);
            lowStep = lowStep.blend(d, d.compare(LT, lowStep).and(active));
            highStep = highStep.blend(d, d.compare(GT, highStep).and(active));
        }
        setAxis(low, high, min(lowStep), max(highStep), at);
    }

    private void boundAxis(float[] start, float[] step, float[] lineWidth, int from, int end, int at) {
        FloatVector low = FloatVector.broadcast(LANES, Float.POSITIVE_INFINITY);
        FloatVector high = low.neg();
        FloatVector lowStep = low;
        FloatVector highStep = high;
        for (int i = from; i < end; i += LaneRays.WIDTH) {
            VectorMask<Float> active = VectorMask.fromLong(LANES, rays >>> i);
            FloatVector o = FloatVector.fromArray(LANES, start, i);
            FloatVector w = FloatVector.fromArray(LANES, lineWidth, i);
            FloatVector d = FloatVector.fromArray(LANES, step, i);
            w = w.add(w);
            FloatVector less = o.sub(w);
            FloatVector more = o.add(w);
            low = low.blend(less, less.compare(LT, low).and(active));
            high = high.blend(more, more.compare(GT, high).and(active));
            lowStep = lowStep.blend(d, d.compare(LT, lowStep).and(active));
            highStep = highStep.blend(d, d.compare(GT, highStep).and(active));
        }
        setAxis(min(low), max(high), min(lowStep), max(highStep), at);
    }

    /** Returns the smallest lane; compares bits in an order that is that of the numbers. */
    private static float min(FloatVector v) {
        int min = ordered(v).reduceLanes(MIN);
        return Float.intBitsToFloat(min ^ min >> 31 & Integer.MAX_VALUE);
    }

    private static float max(FloatVector v) {
        int max = ordered(v).reduceLanes(MAX);
        return Float.intBitsToFloat(max ^ max >> 31 & Integer.MAX_VALUE);
    }

    private static IntVector ordered(FloatVector v) {
        IntVector bits = v.reinterpretAsInts();
        return bits.lanewise(XOR, bits.lanewise(ASHR, 31).and(Integer.MAX_VALUE));
    }

    private void setAxis(float low, float high, float minStep, float maxStep, int at) {
        float lowStep = minStep;
        float highStep = maxStep;
        originSpread = high - low > originSpread ? high - low : originSpread;
        stepSpread = highStep - lowStep > stepSpread ? highStep - lowStep : stepSpread;
        stepCenter[at / 8] = 0.5f * (lowStep + highStep);
        stepExtent[at / 8] = 0.5f * (highStep - lowStep) + STEP_PADDING;
        lowStep -= STEP_PADDING;
        highStep += STEP_PADDING;
        lowStep = lowStep == 0 ? -STEP_PADDING : lowStep;
        highStep = highStep == 0 ? STEP_PADDING : highStep;
        // low + t·lowStep ≤ the maximum holds up to this t for a forward step, and from it on for a backward step.
        float a = 1 / lowStep;
        storeCoefficients(at, lowStep < 0, a, -low * a);
        float b = 1 / highStep;
        storeCoefficients(at + 4, highStep > 0, b, -high * b);
    }

    private void storeCoefficients(int at, boolean isEntry, float factor, float summand) {
        coefficients[at] = isEntry ? factor : 0;
        coefficients[at + 1] = isEntry ? summand : 0;
        coefficients[at + 2] = isEntry ? 0 : factor;
        coefficients[at + 3] = isEntry ? UNREACHED : summand;
    }

    /** Returns the children of a node that the beam touches up to a distance, one bit each; writes {@link #entryBits}. */
    int enteredChildren(MeshTree tree, int node, int limitBits) {
        float[] b = tree.box;
        float[] k = coefficients;
        int at = MeshTree.NODE_FLOATS * node;
        FloatVector lesser = FloatVector.fromArray(FLOATS, b, at);
        FloatVector greater = FloatVector.fromArray(FLOATS, b, at + 8);
        IntVector enters = greater.fma(FloatVector.broadcast(FLOATS, k[0]), FloatVector.broadcast(FLOATS, k[1])).reinterpretAsInts()
                .max(lesser.fma(FloatVector.broadcast(FLOATS, k[4]), FloatVector.broadcast(FLOATS, k[5])).reinterpretAsInts()).max(0);
        IntVector leaves = greater.fma(FloatVector.broadcast(FLOATS, k[2]), FloatVector.broadcast(FLOATS, k[3])).reinterpretAsInts()
                .min(lesser.fma(FloatVector.broadcast(FLOATS, k[6]), FloatVector.broadcast(FLOATS, k[7])).reinterpretAsInts())
                .min(limitBits);
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
        enters.intoArray(entryBits, 0);
        return (int) enters.compare(LE, leaves).toLong();
    }
}
