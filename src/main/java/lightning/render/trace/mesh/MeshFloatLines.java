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
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShape;
import jdk.incubator.vector.VectorSpecies;
import lightning.render.trace.solid.DoubleLanes;
import lightning.render.trace.solid.LaneRays;

/**
 * Conservative float version of a group's lines ({@link MeshLines}) for tests against boxes. Reused; not thread-safe.
 *
 * <p><b>Errors.</b> Let R bound the mesh's |coordinates| plus those of the new origin, v = 2⁻²⁴, and u and c as for the lines.
 * Rounding the origin costs v·R; the inverse 2v of a distance below 2R; its product with the origin v·R; the fused sum v·2R.
 * Together this is less than 8v·R = 2⁻²¹·R. A line flatter than 1 : 2⁶⁰ on an axis drifts by less than 2⁻⁵⁸·R. The new origin
 * is off by less than 4u·(|c| + R).
 *
 * <p>The float line is padded by w = 2⁻²⁰·R + {@code tolerance}. So it crosses every box around a triangle that {@link MeshRay}
 * hits, at no greater distance than the hit.
 */
final class MeshFloatLines {
    private static final VectorSpecies<Double> SPECIES = DoubleLanes.SPECIES;
    private static final VectorSpecies<Float> HALF = MeshRayLanes.HALF;
    private static final VectorSpecies<Integer> HALF_INTS =
            VectorSpecies.of(int.class, VectorShape.forBitSize(SPECIES.vectorBitSize() / 2));
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Float> EIGHT = FloatVector.SPECIES_256;
    /** Maximum inverse of a line's step on an axis. */
    static final double MAX_INVERSE = 0x1p60;
    /** Factor greater than the rounding of a distance to float. */
    private static final double ROUND_UP = 1 + 0x1p-20;

    /** Maximum width; wider lines may overflow floats in products. Coordinates up to 1e18 are safe. */
    static final float MAX_WIDTH = 1e11f;
    private static final int X = MeshTree.AXIS_FLOATS;
    private static final int ALL_SLOTS = -1 >>> -MeshTree.WIDTH;

    private final MeshLines lines;
    /** New start distance of each line, as double. */
    private final double[] startDistance;
    private final double[] maxComponent;
    private boolean startDistanceIsZero;
    /** Common start and width of all lines, if they have one. */
    float sharedX;
    float sharedY;
    float sharedZ;
    float sharedWidth;
    /** Lines as floats; starts and widths of lines with a common start only after {@link #prepareBoxTests}. */
    final float[] startX;
    final float[] startY;
    final float[] startZ;
    final float[] stepX;
    final float[] stepY;
    final float[] stepZ;
    final float[] lineWidth;
    /**
     * The plane {@code x = b} is hit at {@code b·steep + low} from one side of the padded line, and at {@code b·steep + high}
     * from the other.
     */
    final float[] inverseStepX;
    final float[] inverseStepY;
    final float[] inverseStepZ;
    final float[] lowX;
    final float[] lowY;
    final float[] lowZ;
    final float[] highX;
    final float[] highY;
    final float[] highZ;
    /** True if all lines start at one common point, have equal width, and run along their rays. */
    boolean hasSharedStart;
    /** True if the lines are prepared for tests of single rays against boxes. */
    private boolean boxTestsPrepared;
    private int packetCount;
    /** Maximum distance of each line, as float bits; negative for an inactive line. */
    final int[] limitBits;
    /** Entry distances into each child from the latest {@link #enteredChildren}, as float bits. */
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
     * Prepares the lines of the rays of the group.
     *
     * @param active rays of each packet, one bit each; receives the lines that may reach the mesh's box
     * @param tooShort receives the rays of each packet that are too short for lines: shadow rays to a light at the row's
     *     position
     * @param limits maximum distance of each ray
     * @param anyHit true if any hit suffices
     */
    void setRays(MeshTree tree, int[] active, int[] tooShort, int packets, double[] limits, boolean anyHit) {
        packetCount = packets;
        double depth = lines.setRays(tree, active, tooShort, packets, limits, anyHit);
        hasSharedStart = false;
        boxTestsPrepared = !lines.hasSharedStart;
        if (lines.hasSharedStart) {
            setSharedStart(tree, active, tooShort, packets, limits);
            return;
        }
        startDistanceIsZero = false;
        for (int k = 0; k < packets; k++) {
            if (active[k] != 0) {
                computeStarts(tree, depth, k * LaneRays.WIDTH);
                computeIntercepts(startX, inverseStepX, lowX, highX, k * LaneRays.WIDTH);
                computeIntercepts(startY, inverseStepY, lowY, highY, k * LaneRays.WIDTH);
                computeIntercepts(startZ, inverseStepZ, lowZ, highZ, k * LaneRays.WIDTH);
            }
            writeLimits(limits, k * LaneRays.WIDTH, active[k]);
        }
    }

    /** Prepares lines with a common origin, which start there. */
    private void setSharedStart(MeshTree tree, int[] active, int[] tooShort, int packets, double[] limits) {
        float width = (float) ((lines.startCoordinate() + tree.maxCoordinate) * 0x1p-20 + lines.sharedTolerance);
        sharedX = (float) lines.origins[0][lines.firstLine()];
        sharedY = (float) lines.origins[1][lines.firstLine()];
        sharedZ = (float) lines.origins[2][lines.firstLine()];
        sharedWidth = width;
        if (!startDistanceIsZero) {
            Arrays.fill(startDistance, 0);
            startDistanceIsZero = true;
        }
        for (int k = 0; k < packets; k++) {
            lines.computeSteps(k, active, tooShort, stepX, stepY, stepZ);
            writeLimits(limits, k * LaneRays.WIDTH, active[k]);
        }
        hasSharedStart = !lines.hasSkewedRays && width < MAX_WIDTH;
    }

    /**
     * Prepares lines with a common origin for tests of single rays against boxes, unless they are. Many groups need none.
     */
    void prepareBoxTests() {
        if (boxTestsPrepared) {
            return;
        }
        boxTestsPrepared = true;
        int end = packetCount * LaneRays.WIDTH;
        Arrays.fill(startX, 0, end, sharedX);
        Arrays.fill(startY, 0, end, sharedY);
        Arrays.fill(startZ, 0, end, sharedZ);
        Arrays.fill(lineWidth, 0, end, sharedWidth);
        for (int h = 0; h < end; h += LaneRays.WIDTH) {
            computeIntercepts(stepX, startX, inverseStepX, lowX, highX, h);
            computeIntercepts(stepY, startY, inverseStepY, lowY, highY, h);
            computeIntercepts(stepZ, startZ, inverseStepZ, lowZ, highZ, h);
        }
    }

    /** Computes intercepts with inverses of rounded steps, which are off by 2v. */
    private void computeIntercepts(float[] step, float[] start, float[] inverseStep, float[] low, float[] high, int h) {
        FloatVector.broadcast(FLOATS, 1).div(FloatVector.fromArray(FLOATS, step, h)).intoArray(inverseStep, h);
        computeIntercepts(start, inverseStep, low, high, h);
    }

    /** Writes the limits of the lines of a packet. */
    private void writeLimits(double[] limits, int packet, int active) {
        for (int h = packet; active != 0 && h < packet + LaneRays.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector distance = lines.reversed ? broadcast(SPECIES, 1) : fromArray(SPECIES, limits, h);
            ((FloatVector) distance.sub(fromArray(SPECIES, startDistance, h)).mul(fromArray(SPECIES, maxComponent, h)).mul(ROUND_UP)
                    .convertShape(D2F, HALF, 0))
                    .reinterpretAsInts().intoArray(limitBits, h);
        }
        for (int inactive = ~active & -1 >>> -LaneRays.WIDTH; inactive != 0; inactive &= inactive - 1) {
            limitBits[packet + Integer.numberOfTrailingZeros(inactive)] = -1;
        }
    }

    private void computeStarts(MeshTree tree, double depth, int packet) {
        for (int h = packet; h < packet + LaneRays.WIDTH; h += DoubleLanes.COUNT) {
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

    /** Limits ray {@code i} to a distance; only for rays that are not reversed. */
    void setLimit(int i, double distance) {
        limitBits[i] = Float.floatToRawIntBits((float) ((distance - startDistance[i]) * maxComponent[i] * ROUND_UP));
    }

    /** Limits the rays of {@code mask} among {@code h … h + 7} to distances; only for rays that are not reversed. */
    void setLimits(int h, int mask, double[] distance) {
        for (int part = 0; part < LeafTriangleLanes.RAYS; part += DoubleLanes.COUNT) {
            IntVector bits = ((FloatVector) fromArray(SPECIES, distance, h + part).sub(fromArray(SPECIES, startDistance, h + part))
                    .mul(fromArray(SPECIES, maxComponent, h + part)).mul(ROUND_UP).convertShape(D2F, HALF, 0)).reinterpretAsInts();
            IntVector.fromArray(HALF_INTS, limitBits, h + part).blend(bits, VectorMask.fromLong(HALF_INTS, mask >>> part))
                    .intoArray(limitBits, h + part);
        }
    }

    /** Returns the largest limit of the rays {@code i … end − 1}. */
    int maxLimitBits(int i, int end) {
        IntVector max = IntVector.fromArray(INTS, limitBits, i);
        for (int h = i + LaneRays.WIDTH; h < end; h += LaneRays.WIDTH) {
            max = max.max(IntVector.fromArray(INTS, limitBits, h));
        }
        return max.reduceLanes(MAX);
    }

    /** Returns the rays of a set, among the packets {@code from … end − 1}, that may hit the box at {@code b[i]}. */
    long enteringRays(float[] b, int i, long rayMask, int from, int end) {
        long entering = 0;
        for (int h = from; h < end; h += LaneRays.WIDTH) {
            if ((rayMask >>> h & -1 >>> -LaneRays.WIDTH) != 0) {
                entering |= (long) enteringRays(b, i, h) << h;
            }
        }
        return entering & rayMask;
    }

    /** Returns the rays of the packet that starts at {@code h} that may hit the box at {@code b[i]}. */
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

    /** Returns the children of a node that ray {@code i} may hit; writes {@link #entryBits}. */
    int enteredChildren(float[] b, int node, int i) {
        int at = MeshTree.NODE_FLOATS * node;
        float sx = inverseStepX[i];
        float sy = inverseStepY[i];
        float sz = inverseStepZ[i];
        // Selects whether the line reaches the minimum or the maximum side first.
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

    /**
     * Returns the slots of a leaf whose triangles ray {@code i} may hit, if it is active; {@code extent} is the longest side of
     * the leaf's box.
     */
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
            return LeafTriangleCulling.candidateSlots(v, at, at + X, at + 2 * X, startX[i], startY[i], startZ[i], dx * dz, dy * dz, w,
                    extent);
        }
        return Math.abs(dx) == 1
                ? LeafTriangleCulling.candidateSlots(v, at + X, at + 2 * X, at, startY[i], startZ[i], startX[i], dy * dx, dz * dx, w,
                        extent)
                : LeafTriangleCulling.candidateSlots(v, at + 2 * X, at, at + X, startZ[i], startX[i], startY[i], dz * dy, dx * dy, w,
                        extent);
    }
}
