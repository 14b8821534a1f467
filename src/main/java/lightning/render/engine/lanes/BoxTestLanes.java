package lightning.render.engine.lanes;

import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorShuffle;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.primitive.PrimitiveBoxes;
import lightning.render.trace.solid.DoubleLanes;

/**
 * Rays of a packet as floats for tests against boxes.
 *
 * <p>Tests only reject, so rounding is harmless as long as boxes are padded by more than its total ({@link PrimitiveBoxes});
 * fused multiply-add is allowed. The plane {@code x = b} is hit at {@code b·inverse + shift}. Distances are in units of the
 * direction's largest component, so that every inverse has an absolute value from 1 to {@link #MAX_INVERSE} and no product
 * overflows.
 */
final class BoxTestLanes {
    private static final VectorSpecies<Float> SPECIES = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> BITS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> HALF =
            VectorSpecies.of(float.class, VectorShape.forBitSize(DoubleLanes.SPECIES.vectorBitSize() / 2));
    private static final VectorShuffle<Float> SWAP =
            VectorShuffle.fromOp(SPECIES, i -> (i + DoubleLanes.COUNT) % RayPacket.WIDTH);
    private static final VectorMask<Float> UPPER = VectorMask.fromLong(SPECIES, -1L << DoubleLanes.COUNT);
    /** A ray flatter on an axis than 1 : 2⁶⁰ drifts by less than the padding of the boxes. */
    private static final float MAX_INVERSE = 0x1p60f;
    /** Factor greater than the rounding of a distance to float. */
    private static final float ROUND_UP = 1 + 0x1p-20f;

    private final float[] inverseX = new float[RayPacket.WIDTH];
    private final float[] inverseY = new float[RayPacket.WIDTH];
    private final float[] inverseZ = new float[RayPacket.WIDTH];
    private final float[] shiftX = new float[RayPacket.WIDTH];
    private final float[] shiftY = new float[RayPacket.WIDTH];
    private final float[] shiftZ = new float[RayPacket.WIDTH];
    /** Largest component of each direction. */
    private final float[] maxComponent = new float[RayPacket.WIDTH];
    /** Distance beyond which boxes are missed: float bits, rounded up. */
    private final int[] limitBits = new int[RayPacket.WIDTH];

    /** Sets the packet's rays, without limits. */
    void setRays(RayPacket p) {
        toFloats(p.dx).intoArray(inverseX, 0);
        toFloats(p.dy).intoArray(inverseY, 0);
        toFloats(p.dz).intoArray(inverseZ, 0);
        // Absolute values: their bits have the same order.
        FloatVector.fromArray(SPECIES, inverseX, 0).abs().reinterpretAsInts()
                .max(FloatVector.fromArray(SPECIES, inverseY, 0).abs().reinterpretAsInts())
                .max(FloatVector.fromArray(SPECIES, inverseZ, 0).abs().reinterpretAsInts())
                .reinterpretAsFloats().intoArray(maxComponent, 0);
        computeAxis(p.ox, inverseX, shiftX);
        computeAxis(p.oy, inverseY, shiftY);
        computeAxis(p.oz, inverseZ, shiftZ);
        FloatVector.broadcast(SPECIES, Float.POSITIVE_INFINITY).reinterpretAsInts().intoArray(limitBits, 0);
    }

    /** Replaces the direction in {@code inverse}. */
    private void computeAxis(double[] o, float[] inverse, float[] shift) {
        FloatVector i = FloatVector.fromArray(SPECIES, maxComponent, 0).div(FloatVector.fromArray(SPECIES, inverse, 0));
        i = i.blend(MAX_INVERSE, i.compare(GT, MAX_INVERSE)).blend(-MAX_INVERSE, i.compare(LT, -MAX_INVERSE));
        i.intoArray(inverse, 0);
        toFloats(o).neg().mul(i).intoArray(shift, 0);
    }

    /** Combines the halves in registers: two stores of half a vector would stall the load of the whole one. */
    private static FloatVector toFloats(double[] from) {
        FloatVector low = (FloatVector) DoubleVector.fromArray(DoubleLanes.SPECIES, from, 0).convertShape(D2F, HALF, 0);
        FloatVector high = (FloatVector) DoubleVector.fromArray(DoubleLanes.SPECIES, from, DoubleLanes.COUNT).convertShape(D2F, HALF, 0);
        return ((FloatVector) low.reinterpretShape(SPECIES, 0))
                .blend(((FloatVector) high.reinterpretShape(SPECIES, 0)).rearrange(SWAP), UPPER);
    }

    /** Sets the limits to the given distances, rounded up. */
    void setLimits(double[] distances) {
        toFloats(distances).mul(FloatVector.fromArray(SPECIES, maxComponent, 0)).mul(ROUND_UP)
                .reinterpretAsInts().intoArray(limitBits, 0);
    }

    /**
     * Returns the rays that may hit the box {@code boxes[at … at + 5]}, one bit per lane.
     *
     * <p>Distances are compared as integers, one instruction instead of the six required for Java's order of ±0 and NaN.
     * Integers order positive floats correctly. Negative ones are in the wrong order but before all positive ones, and only
     * their sign matters.
     */
    long hits(float[] boxes, int at) {
        FloatVector inverse = FloatVector.fromArray(SPECIES, inverseX, 0);
        FloatVector shift = FloatVector.fromArray(SPECIES, shiftX, 0);
        IntVector a = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at]), shift).reinterpretAsInts();
        IntVector b = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at + 3]), shift).reinterpretAsInts();
        IntVector in = a.min(b).max(0);
        IntVector out = a.max(b).min(IntVector.fromArray(BITS, limitBits, 0));
        inverse = FloatVector.fromArray(SPECIES, inverseY, 0);
        shift = FloatVector.fromArray(SPECIES, shiftY, 0);
        a = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at + 1]), shift).reinterpretAsInts();
        b = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at + 4]), shift).reinterpretAsInts();
        in = in.max(a.min(b));
        out = out.min(a.max(b));
        inverse = FloatVector.fromArray(SPECIES, inverseZ, 0);
        shift = FloatVector.fromArray(SPECIES, shiftZ, 0);
        a = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at + 2]), shift).reinterpretAsInts();
        b = inverse.fma(FloatVector.broadcast(SPECIES, boxes[at + 5]), shift).reinterpretAsInts();
        in = in.max(a.min(b));
        out = out.min(a.max(b));
        return in.compare(LE, out).toLong();
    }

    /**
     * Computes {@link #hits(float[], int)} for several boxes in one loop: a third of the time, since the rays stay in
     * registers. Writes one mask per box.
     */
    void hits(float[] boxes, int from, int count, int[] masks) {
        FloatVector inverseX = FloatVector.fromArray(SPECIES, this.inverseX, 0);
        FloatVector inverseY = FloatVector.fromArray(SPECIES, this.inverseY, 0);
        FloatVector inverseZ = FloatVector.fromArray(SPECIES, this.inverseZ, 0);
        FloatVector shiftX = FloatVector.fromArray(SPECIES, this.shiftX, 0);
        FloatVector shiftY = FloatVector.fromArray(SPECIES, this.shiftY, 0);
        FloatVector shiftZ = FloatVector.fromArray(SPECIES, this.shiftZ, 0);
        IntVector end = IntVector.fromArray(BITS, limitBits, 0);
        for (int c = 0; c < count; c++) {
            int at = from + 6 * c;
            IntVector a = inverseX.fma(FloatVector.broadcast(SPECIES, boxes[at]), shiftX).reinterpretAsInts();
            IntVector b = inverseX.fma(FloatVector.broadcast(SPECIES, boxes[at + 3]), shiftX).reinterpretAsInts();
            IntVector in = a.min(b).max(0);
            IntVector out = a.max(b).min(end);
            a = inverseY.fma(FloatVector.broadcast(SPECIES, boxes[at + 1]), shiftY).reinterpretAsInts();
            b = inverseY.fma(FloatVector.broadcast(SPECIES, boxes[at + 4]), shiftY).reinterpretAsInts();
            in = in.max(a.min(b));
            out = out.min(a.max(b));
            a = inverseZ.fma(FloatVector.broadcast(SPECIES, boxes[at + 2]), shiftZ).reinterpretAsInts();
            b = inverseZ.fma(FloatVector.broadcast(SPECIES, boxes[at + 5]), shiftZ).reinterpretAsInts();
            in = in.max(a.min(b));
            out = out.min(a.max(b));
            masks[c] = (int) in.compare(LE, out).toLong();
        }
    }
}
