package lightning.render.trace.mesh;

import static jdk.incubator.vector.DoubleVector.broadcast;
import static jdk.incubator.vector.DoubleVector.fromArray;
import static jdk.incubator.vector.VectorOperators.D2F;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;
import static jdk.incubator.vector.VectorOperators.MAX;

import java.util.Arrays;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.RayBatch;

/**
 * The lines of a group ({@link MeshLines}) as floats, to be tested against boxes: what may be met. Reused; not shared between threads.
 *
 * <p><b>Floats.</b> With R a bound on the mesh's |coordinates| plus those of the new origin and v = 2⁻²⁴: rounding that origin takes
 * v·R, the inverse 2v of a distance below 2R, its product with the origin v·R, the fused sum v·2R; together less than 8v·R, that is 2⁻²¹·R. A line
 * flatter than 1 : 2⁶⁰ on an axis drifts by less than 2⁻⁵⁸·R. The new origin is off by less than 4u·(|c| + R), u and c as those of the lines. The floats' line is made wide by
 * 2⁻²⁰·R + {@code loose} = w, so that it crosses every box that holds a triangle which {@link MeshRay} meets, and no later than that is met.
 */
final class MeshFloatLines {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final VectorSpecies<Float> HALF = MeshRayLanes.HALF;
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    /** No line is flatter on an axis than 1 to this. */
    static final double MAX_INVERSE = 0x1p60;
    /** More than the rounding of a distance to float. */
    private static final double ROUND_UP = 1 + 0x1p-20;

    /** Wider lines may have products that are no floats: those of coordinates up to 1e18 are. */
    private static final float MAX_WIDTH = 1e11f;
    private static final int ALL_SLOTS = -1 >>> -MeshTree.WIDTH;

    private final MeshLines lines;
    /** Where each line begins anew, in doubles. */
    private final double[] startDistance;
    private final double[] maxComponent;
    /** The lines in floats. */
    final float[] startX;
    final float[] startY;
    final float[] startZ;
    final float[] stepX;
    final float[] stepY;
    final float[] stepZ;
    final float[] lineWidth;
    /** The plane {@code x = b} is met at {@code b·steep + low}, seen from the wide line's one side, and at {@code b·steep + high} from the other. */
    private final float[] inverseStepX;
    private final float[] inverseStepY;
    private final float[] inverseStepZ;
    private final float[] lowX;
    private final float[] lowY;
    private final float[] lowZ;
    private final float[] highX;
    private final float[] highY;
    private final float[] highZ;
    /** Whether all lines come from one point, begin there, are as wide, and run along their rays. */
    boolean hasSharedStart;
    /** How far each line goes, as the bits of a float; negative for one that goes nowhere. */
    final int[] limitBits;
    /** Where line {@link #enteredChildren} enters each child, as the bits of floats. */
    final int[] entryBits = new int[MeshTree.WIDTH];

    MeshFloatLines(MeshRayLanes rays, int capacity) {
        lines = new MeshLines(rays, capacity);
        startDistance = lines.startDistance;
        maxComponent = lines.maxComponent;
        startX = new float[capacity];
        startY = new float[capacity];
        startZ = new float[capacity];
        stepX = new float[capacity];
        stepY = new float[capacity];
        stepZ = new float[capacity];
        lineWidth = new float[capacity];
        inverseStepX = new float[capacity];
        inverseStepY = new float[capacity];
        inverseStepZ = new float[capacity];
        lowX = new float[capacity];
        lowY = new float[capacity];
        lowZ = new float[capacity];
        highX = new float[capacity];
        highY = new float[capacity];
        highZ = new float[capacity];
        limitBits = new int[capacity];
    }

    /**
     * Looks at the rays that were taken.
     *
     * @param active   those of each packet, one bit for each; gets those that are seen as lines that may reach the mesh's box
     * @param tooShort  gets those of each packet that are too short to be seen as lines: ways to a light at a row's very point
     * @param limits how far each goes
     * @param anyHit    whether it is enough to know that something is met
     */
    void setRays(MeshTree tree, int[] active, int[] tooShort, int packets, double[] limits, boolean anyHit) {
        double depth = lines.setRays(tree, active, tooShort, packets, limits, anyHit);
        hasSharedStart = false;
        if (lines.hasSharedStart) {
            setSharedStart(tree, active, packets, limits);
            return;
        }
        for (int k = 0; k < packets; k++) {
            if (active[k] != 0) {
                computeStarts(tree, depth, k * RayBatch.WIDTH);
                computeIntercepts(startX, inverseStepX, lowX, highX, k * RayBatch.WIDTH);
                computeIntercepts(startY, inverseStepY, lowY, highY, k * RayBatch.WIDTH);
                computeIntercepts(startZ, inverseStepZ, lowZ, highZ, k * RayBatch.WIDTH);
            }
            writeLimits(limits, k * RayBatch.WIDTH, active[k]);
        }
    }

    /** Looks at lines from one point, which begin there. */
    private void setSharedStart(MeshTree tree, int[] active, int packets, double[] limits) {
        float width = (float) ((lines.startCoordinate() + tree.maxCoordinate) * 0x1p-20 + lines.tolerance[0]);
        int end = packets * RayBatch.WIDTH;
        Arrays.fill(startX, 0, end, (float) lines.origins[0][lines.firstLine()]);
        Arrays.fill(startY, 0, end, (float) lines.origins[1][lines.firstLine()]);
        Arrays.fill(startZ, 0, end, (float) lines.origins[2][lines.firstLine()]);
        Arrays.fill(lineWidth, 0, end, width);
        Arrays.fill(startDistance, 0, end, 0);
        for (int k = 0; k < packets; k++) {
            if (active[k] != 0) {
                computeSteps(lines.directions[0], lines.inverseDirections[0], stepX, inverseStepX, k * RayBatch.WIDTH);
                computeSteps(lines.directions[1], lines.inverseDirections[1], stepY, inverseStepY, k * RayBatch.WIDTH);
                computeSteps(lines.directions[2], lines.inverseDirections[2], stepZ, inverseStepZ, k * RayBatch.WIDTH);
                computeIntercepts(startX, inverseStepX, lowX, highX, k * RayBatch.WIDTH);
                computeIntercepts(startY, inverseStepY, lowY, highY, k * RayBatch.WIDTH);
                computeIntercepts(startZ, inverseStepZ, lowZ, highZ, k * RayBatch.WIDTH);
            }
            writeLimits(limits, k * RayBatch.WIDTH, active[k]);
        }
        hasSharedStart = !lines.hasSkewedRays && width < MAX_WIDTH;
    }

    private void computeSteps(double[] directions, double[] inverseDirections, float[] step, float[] inverseStep, int packet) {
        for (int h = packet; h < packet + RayBatch.WIDTH; h += DoubleLanes.COUNT) {
            ((FloatVector) fromArray(SPECIES, directions, h).mul(fromArray(SPECIES, lines.inverseMaxComponent, h)).convertShape(D2F, HALF,
                    0)).intoArray(step,
                            h);
            ((FloatVector) fromArray(SPECIES, inverseDirections, h).mul(fromArray(SPECIES, maxComponent, h)).convertShape(D2F, HALF, 0))
                    .intoArray(inverseStep, h);
        }
    }

    /** Writes how far the lines of a packet go. */
    private void writeLimits(double[] limits, int packet, int active) {
        for (int h = packet; active != 0 && h < packet + RayBatch.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector distance = lines.reversed ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h);
            ((FloatVector) distance.sub(fromArray(SPECIES, startDistance, h)).mul(fromArray(SPECIES, maxComponent, h)).mul(ROUND_UP)
                    .convertShape(D2F, HALF, 0))
                    .reinterpretAsInts().intoArray(limitBits, h);
        }
        for (int inactive = ~active & -1 >>> -RayBatch.WIDTH; inactive != 0; inactive &= inactive - 1) {
            limitBits[packet + Integer.numberOfTrailingZeros(inactive)] = -1;
        }
    }

    private void computeStarts(MeshTree tree, double depth, int packet) {
        for (int h = packet; h < packet + RayBatch.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector inverseLength = fromArray(SPECIES, lines.inverseMaxComponent, h);
            DoubleVector length = fromArray(SPECIES, maxComponent, h);
            DoubleVector t = inverseLength.mul(depth);
            t.intoArray(startDistance, h);
            DoubleVector g = fromArray(SPECIES, lines.directions[0], h);
            DoubleVector startComponent = g.mul(t).add(fromArray(SPECIES, lines.origins[0], h));
            DoubleVector maxCoordinate = startComponent.abs();
            ((FloatVector) startComponent.convertShape(D2F, HALF, 0)).intoArray(startX, h);
            ((FloatVector) g.mul(inverseLength).convertShape(D2F, HALF, 0)).intoArray(stepX, h);
            ((FloatVector) fromArray(SPECIES, lines.inverseDirections[0], h).mul(length).convertShape(D2F, HALF, 0)).intoArray(inverseStepX,
                    h);
            g = fromArray(SPECIES, lines.directions[1], h);
            startComponent = g.mul(t).add(fromArray(SPECIES, lines.origins[1], h));
            maxCoordinate = maxCoordinate.reinterpretAsLongs().max(startComponent.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) startComponent.convertShape(D2F, HALF, 0)).intoArray(startY, h);
            ((FloatVector) g.mul(inverseLength).convertShape(D2F, HALF, 0)).intoArray(stepY, h);
            ((FloatVector) fromArray(SPECIES, lines.inverseDirections[1], h).mul(length).convertShape(D2F, HALF, 0)).intoArray(inverseStepY,
                    h);
            g = fromArray(SPECIES, lines.directions[2], h);
            startComponent = g.mul(t).add(fromArray(SPECIES, lines.origins[2], h));
            maxCoordinate = maxCoordinate.reinterpretAsLongs().max(startComponent.abs().reinterpretAsLongs()).reinterpretAsDoubles();
            ((FloatVector) startComponent.convertShape(D2F, HALF, 0)).intoArray(startZ, h);
            ((FloatVector) g.mul(inverseLength).convertShape(D2F, HALF, 0)).intoArray(stepZ, h);
            ((FloatVector) fromArray(SPECIES, lines.inverseDirections[2], h).mul(length).convertShape(D2F, HALF, 0)).intoArray(inverseStepZ,
                    h);
            ((FloatVector) maxCoordinate.add(tree.maxCoordinate).mul(0x1p-20).add(fromArray(SPECIES, lines.tolerance, h)).convertShape(D2F,
                    HALF, 0))
                    .intoArray(lineWidth, h);
        }
    }

    private void computeIntercepts(float[] start, float[] inverseStep, float[] low, float[] high, int h) {
        FloatVector i = FloatVector.fromArray(FLOATS, inverseStep, h);
        i = i.blend((float) MAX_INVERSE, i.compare(GT, (float) MAX_INVERSE)).blend((float) -MAX_INVERSE,
                i.compare(LT, (float) -MAX_INVERSE));
        i.intoArray(inverseStep, h);
        FloatVector o = FloatVector.fromArray(FLOATS, start, h);
        FloatVector width = FloatVector.fromArray(FLOATS, lineWidth, h);
        o.add(width).neg().mul(i).intoArray(low, h);
        o.sub(width).neg().mul(i).intoArray(high, h);
    }

    /** Lets ray {@code i} go no farther than a distance; only of rays seen forwards. */
    void setLimit(int i, double distance) {
        limitBits[i] = Float.floatToRawIntBits((float) ((distance - startDistance[i]) * maxComponent[i] * ROUND_UP));
    }

    /** How far any of the rays {@code i … end − 1} still goes. */
    int maxLimitBits(int i, int end) {
        IntVector max = IntVector.fromArray(INTS, limitBits, i);
        for (int h = i + RayBatch.WIDTH; h < end; h += RayBatch.WIDTH) {
            max = max.max(IntVector.fromArray(INTS, limitBits, h));
        }
        return max.reduceLanes(MAX);
    }

    /** Which rays of a set among those of the packets {@code from … end − 1} may meet the box at {@code b[i]}. */
    long enteringRays(float[] b, int i, long rayMask, int from, int end) {
        long entering = 0;
        for (int h = from; h < end; h += RayBatch.WIDTH) {
            if ((rayMask >>> h & -1 >>> -RayBatch.WIDTH) != 0) {
                entering |= (long) enteringRays(b, i, h) << h;
            }
        }
        return entering & rayMask;
    }

    /** Which rays of the packet from {@code h} on may meet the box at {@code b[i]}. */
    int enteringRays(float[] b, int i, int h) {
        FloatVector inverseStep = FloatVector.fromArray(FLOATS, inverseStepX, h);
        IntVector p = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i]), FloatVector.fromArray(FLOATS, lowX, h)).reinterpretAsInts();
        IntVector q = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i + 8]), FloatVector.fromArray(FLOATS, highX, h)).reinterpretAsInts();
        IntVector enters = p.min(q).max(0);
        IntVector leaves = p.max(q).min(IntVector.fromArray(INTS, limitBits, h));
        inverseStep = FloatVector.fromArray(FLOATS, inverseStepY, h);
        p = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i + 16]), FloatVector.fromArray(FLOATS, lowY, h)).reinterpretAsInts();
        q = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i + 24]), FloatVector.fromArray(FLOATS, highY, h)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        inverseStep = FloatVector.fromArray(FLOATS, inverseStepZ, h);
        p = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i + 32]), FloatVector.fromArray(FLOATS, lowZ, h)).reinterpretAsInts();
        q = inverseStep.fma(FloatVector.broadcast(FLOATS, b[i + 40]), FloatVector.fromArray(FLOATS, highZ, h)).reinterpretAsInts();
        enters = enters.max(p.min(q));
        leaves = leaves.min(p.max(q));
        return (int) enters.compare(LE, leaves).toLong();
    }

    /** Which children of a node ray {@code i} may meet; writes {@link #entryBits}. */
    int enteredChildren(float[] b, int node, int i) {
        int at = MeshTree.NODE_FLOATS * node;
        float sx = inverseStepX[i];
        float sy = inverseStepY[i];
        float sz = inverseStepZ[i];
        // Whether it comes to the lesser or to the greater side first.
        int x = sx > 0 ? at : at + 8;
        int y = sy > 0 ? at + 16 : at + 24;
        int z = sz > 0 ? at + 32 : at + 40;
        FloatVector inverseStep = FloatVector.broadcast(EIGHT, sx);
        IntVector enters = FloatVector.fromArray(EIGHT, b, x).fma(inverseStep, FloatVector.broadcast(EIGHT, sx > 0 ? lowX[i] : highX[i]))
                .reinterpretAsInts().max(0);
        IntVector leaves = FloatVector.fromArray(EIGHT, b, 2 * at + 8 - x)
                .fma(inverseStep, FloatVector.broadcast(EIGHT, sx > 0 ? highX[i] : lowX[i])).reinterpretAsInts().min(limitBits[i]);
        inverseStep = FloatVector.broadcast(EIGHT, sy);
        enters = enters.max(FloatVector.fromArray(EIGHT, b, y).fma(inverseStep, FloatVector.broadcast(EIGHT, sy > 0 ? lowY[i] : highY[i]))
                .reinterpretAsInts());
        leaves = leaves.min(FloatVector.fromArray(EIGHT, b, 2 * at + 40 - y)
                .fma(inverseStep, FloatVector.broadcast(EIGHT, sy > 0 ? highY[i] : lowY[i])).reinterpretAsInts());
        inverseStep = FloatVector.broadcast(EIGHT, sz);
        enters = enters.max(FloatVector.fromArray(EIGHT, b, z).fma(inverseStep, FloatVector.broadcast(EIGHT, sz > 0 ? lowZ[i] : highZ[i]))
                .reinterpretAsInts());
        leaves = leaves.min(FloatVector.fromArray(EIGHT, b, 2 * at + 72 - z)
                .fma(inverseStep, FloatVector.broadcast(EIGHT, sz > 0 ? highZ[i] : lowZ[i])).reinterpretAsInts());
        enters.intoArray(entryBits, 0);
        return (int) enters.compare(LE, leaves).toLong();
    }

    /** The slots of a leaf whose triangles ray {@code i} may meet, where it is open; {@code extent} is the longest side of the leaf's box. */
    int candidateSlots(float[] v, int leaf, float extent, int i) {
        float w = lineWidth[i];
        if (!(w < MAX_WIDTH) || lines.hasSkewedRays) {
            return ALL_SLOTS;
        }
        float dx = stepX[i];
        float dy = stepY[i];
        float dz = stepZ[i];
        int at = MeshTree.LEAF_FLOATS * leaf;
        if (Math.abs(dz) == 1) {
            return LeafTriangleCulling.candidateSlots(v, at, at + 8, at + 16, startX[i], startY[i], startZ[i], dx * dz, dy * dz, w, extent);
        }
        return Math.abs(dx) == 1
                ? LeafTriangleCulling.candidateSlots(v, at + 8, at + 16, at, startY[i], startZ[i], startX[i], dy * dx, dz * dx, w, extent)
                : LeafTriangleCulling.candidateSlots(v, at + 16, at, at + 8, startZ[i], startX[i], startY[i], dz * dy, dx * dy, w, extent);
    }
}
